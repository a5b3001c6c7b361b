use super::density::Density;
use super::{Integrand, Integrator, uniform};
use crate::capability::Capability;
use crate::parameter::{ParameterError, require};

/// The mean of so many independent draws, from a density of one's own or uniform.
///
/// ```text
/// X = (1/m) sum_(i = 1 to m) f(x_i)/p(x_i),   Var[X] = (int f^2/p - F^2) / m
/// ```
///
/// Target: any integral, if p > 0 wherever f is not 0.
/// Range:  that of f/p.
/// Cost:   m times that of one draw.
/// Needs:  a density in x that has mass 1 on the domain, or none.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AverageOf {
    /// m, from 1 to 10,000.
    #[schemars(range(min = 1, max = 10_000), example = 16)]
    draws: u32,
    /// The density, 1/length: a formula in x (default: uniform).
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pdf: Option<Density>,
}

impl Integrator for AverageOf {
    fn estimate(&self, integrand: &Integrand, rng: &mut dyn rand::Rng) -> f64 {
        let mut one = || {
            let u = freepath_draws::random::uniform(rng);
            self.pdf.as_ref().map_or_else(|| uniform::weighed(integrand, u), |pdf| pdf.weighed(integrand, u))
        };
        (0..self.draws).map(|_| one()).sum::<f64>() / f64::from(self.draws)
    }
    fn pdf(&self, integrand: &Integrand, x: f64) -> Option<f64> {
        Some(self.pdf.as_ref().map_or(1.0 / integrand.length(), |pdf| pdf.at(x)))
    }
    fn draws(&self) -> u32 {
        self.draws
    }
    fn accepts(&self, integrand: &Integrand) -> Result<(), ParameterError> {
        require((1..=10_000).contains(&self.draws), "draws", self.draws, "a whole number from 1 to 10000")?;
        self.pdf.as_ref().map_or(Ok(()), |pdf| pdf.accepts("pdf", integrand))
    }
    fn capabilities(&self) -> Vec<Capability> {
        vec![Capability::Density]
    }
}

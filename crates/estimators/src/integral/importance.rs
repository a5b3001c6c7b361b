use super::density::Density;
use super::{Integrand, Integrator};
use crate::capability::Capability;
use crate::parameter::ParameterError;
use freepath_draws::random::uniform;

/// Importance sampling: places drawn from a density of one's own, by inversion (Kahn and Marshall 1953).
///
/// ```text
/// X = f(x)/p(x),   x ~ p,   Var[X] = int f^2/p - F^2
/// ```
///
/// Target: any integral, if p > 0 wherever f is not 0. A density that vanishes faster than f^2 makes the variance infinite.
/// Range:  that of f/p.
/// Cost:   one uniform, some 6 evaluations of the distribution function, one of f and of p.
/// Needs:  a density in x that has mass 1 on the domain.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Importance {
    /// The density, 1/length: a formula in x.
    #[schemars(example = "x/2")]
    pdf: Density,
}

impl Integrator for Importance {
    fn estimate(&self, integrand: &Integrand, rng: &mut dyn rand::Rng) -> f64 {
        self.pdf.weighed(integrand, uniform(rng))
    }
    fn pdf(&self, _: &Integrand, x: f64) -> Option<f64> {
        Some(self.pdf.at(x))
    }
    fn accepts(&self, integrand: &Integrand) -> Result<(), ParameterError> {
        self.pdf.accepts("pdf", integrand)
    }
    fn capabilities(&self) -> Vec<Capability> {
        vec![Capability::Density]
    }
}

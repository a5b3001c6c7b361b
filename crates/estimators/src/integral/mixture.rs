use super::density::Density;
use super::{Integrand, Integrator, Sampled};
use crate::capability::Capability;
use crate::parameter::{ParameterError, require};
use freepath_draws::random::uniform;

/// Importance sampling from a mixture of densities, divided by the density of the mixture (the balance heuristic, Veach and Guibas 1995).
///
/// ```text
/// X = f(x) / sum_i k_i p_i(x),   x ~ p_i with probability k_i,   sum k_i = 1, k_i >= 0
/// ```
///
/// Target: any integral, if some p_i > 0 with k_i > 0 wherever f is not 0.
/// Range:  that of f over the mixture.
/// Cost:   two uniforms, some 6 evaluations of a distribution function, one of f and of each p_i.
/// Needs:  densities in x that have mass 1 on the domain.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Mixture {
    /// The densities, 1/length: formulas in x.
    #[schemars(example = densities())]
    of: Vec<Density>,
    /// The probability of each, k_i: not negative, with sum 1.
    #[schemars(example = halves())]
    weights: Vec<f64>,
}

fn densities() -> [&'static str; 2] {
    ["1/2", "x/2"]
}

fn halves() -> [f64; 2] {
    [0.5, 0.5]
}

/// How far the sum of the weights may be off.
const ROUNDING: f64 = 1e-12;

impl Mixture {
    fn density(&self, x: f64) -> f64 {
        self.weights.iter().zip(&self.of).map(|(weight, density)| weight * density.at(x)).sum()
    }

    /// The component at a probability.
    fn component(&self, u: f64) -> &Density {
        let mut rest = u;
        let hit = |(weight, _): &(&f64, &Density)| {
            rest -= **weight;
            rest < 0.0
        };
        let last = self.weights.iter().rposition(|weight| *weight > 0.0).unwrap_or(0);
        self.weights.iter().zip(&self.of).find(hit).map_or(&self.of[last], |(_, density)| density)
    }
}

impl Integrator for Mixture {
    fn estimate(&self, integrand: &Integrand, rng: &mut dyn rand::Rng) -> f64 {
        let (component, u) = (self.component(uniform(rng)), uniform(rng));
        let x = component.quantile(integrand, u);
        let (pdf, density) = (self.density(x), |x| self.density(x));
        let (f, component, end) = (integrand.f(x), component.at(x), integrand.domain()[1]);
        integrand.weight(&Sampled { f, u, pdf, density: &density, component, end })
    }

    fn pdf(&self, _: &Integrand, x: f64) -> Option<f64> {
        Some(self.density(x))
    }

    fn accepts(&self, integrand: &Integrand) -> Result<(), ParameterError> {
        let (n, k) = (self.of.len(), self.weights.len());
        require(n >= 1 && n == k, "weights", format!("{k} of them for {n} densities"), "one for each density")?;
        for &weight in &self.weights {
            require(weight >= 0.0 && weight <= 1.0, "weights", weight, "probabilities, from 0 to 1")?;
        }
        let sum: f64 = self.weights.iter().sum();
        let must_be = "with a sum of 1, or the mean is off by that factor";
        require((sum - 1.0).abs() <= ROUNDING, "weights", format!("with a sum of {sum}"), must_be)?;
        self.of.iter().try_for_each(|density| density.is_one("of", integrand))?;
        integrand.covered("of", |x| self.density(x))
    }

    fn capabilities(&self) -> Vec<Capability> {
        vec![Capability::Density, Capability::MixtureOfDensities]
    }
}

use super::{Integrand, Integrator, Sampled};
use crate::capability::Capability;

/// The mean of f over uniform places, times the length of the interval (crude Monte Carlo).
///
/// ```text
/// X = (b - a) f(a + (b - a) u),   Var[X] = (b - a) int f^2 - F^2
/// ```
///
/// Target: any integral; its variance is finite where that of f^2 is.
/// Range:  (b - a) times that of f.
/// Cost:   one uniform, one evaluation of f.
/// Needs:  nothing.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Uniform {}

/// The estimate of a uniform place.
pub(super) fn weighed(integrand: &Integrand, u: f64) -> f64 {
    let ([a, end], pdf) = (integrand.domain(), 1.0 / integrand.length());
    let f = integrand.f(a + integrand.length() * u);
    integrand.weight(&Sampled { f, u, pdf, density: &|_| pdf, component: pdf, end })
}

impl Integrator for Uniform {
    fn estimate(&self, integrand: &Integrand, rng: &mut dyn rand::Rng) -> f64 {
        weighed(integrand, freepath_draws::random::uniform(rng))
    }
    fn pdf(&self, integrand: &Integrand, _: f64) -> Option<f64> {
        Some(1.0 / integrand.length())
    }
    fn capabilities(&self) -> Vec<Capability> {
        vec![Capability::Density]
    }
}

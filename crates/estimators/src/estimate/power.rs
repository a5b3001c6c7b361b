use super::Estimator;
use freepath_draws::random::uniform;

/// A power of a uniform number: the estimator of an integral that everybody knows.
///
/// ```text
/// X = u^k,   E[X] = 1/(k + 1),   Var[X] = 1/(2k + 1) - 1/(k + 1)^2
/// ```
///
/// Target: 1/(k + 1), the integral of x^k over [0, 1].
/// Range:  [0, 1).
/// Cost:   one uniform.
/// Needs:  nothing of a scene.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Power {
    /// k.
    #[schemars(range(min = 0, max = 64))]
    pub exponent: u8,
}

impl Estimator for Power {
    fn estimate(&self, rng: &mut dyn rand::Rng) -> f64 {
        let u = uniform(rng);
        (0..self.exponent).fold(1.0, |power, _| power * u)
    }
}

use crate::fault::{BlockContext, Injection, Target};
use freepath_draws::{Draws, MissingColumn, column};
use freepath_estimators::ParameterError;
use freepath_estimators::parameter::not_negative;

/// Absorption is in the flight and once more in the weight (structural-color, issue 51).
///
/// ```text
/// right: mu_t with the albedo as weight, or mu_s with exp(-mu_a t);   wrong: mu_t with exp(-mu_a t)
/// ```
///
/// Shows in: the mean at the end of the ray; hardly where little is absorbed.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AbsorbedTwice {
    /// Absorption, the part of mu that is counted twice, 1/length.
    mu_a: f64,
}

impl Injection for AbsorbedTwice {
    fn check(&self) -> Result<(), ParameterError> {
        not_negative("mu_a", self.mu_a).map(drop)
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.draws_estimates()?;
        target.crosses_a_medium()
    }
    fn corrupt_draws(&self, context: &BlockContext, draws: &mut Draws) -> Result<(), MissingColumn> {
        let factor = libm::exp(-self.mu_a * context.length);
        draws.f64_mut(column::WEIGHT)?.iter_mut().for_each(|weight| *weight *= factor);
        Ok(())
    }
}

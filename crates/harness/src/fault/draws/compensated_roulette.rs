use crate::fault::{BlockContext, Injection, Target};
use freepath_draws::random::uniform;
use freepath_draws::{Draws, MissingColumn, column};
use freepath_estimators::ParameterError;
use freepath_estimators::parameter::{finite, require};

/// Harmless: estimates below a threshold die by roulette, and the survivors are raised.
///
/// ```text
/// right: w := w / p with probability p, else 0
/// ```
///
/// Shows in: the second moment alone, which is the estimator's no more. A harness that finds a bias is too strict.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompensatedRoulette {
    /// Estimates below it play.
    below: f64,
    /// Probability of survival.
    survival: f64,
}

impl Injection for CompensatedRoulette {
    fn check(&self) -> Result<(), ParameterError> {
        finite("below", self.below)?;
        let allowed = self.survival > 0.0 && self.survival <= 1.0;
        require(allowed, "survival", self.survival, "above 0 and at most 1").map(drop)
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.draws_estimates()
    }
    fn corrupt_draws(&self, context: &BlockContext, draws: &mut Draws) -> Result<(), MissingColumn> {
        let mut rng = context.rng();
        for weight in draws.f64_mut(column::WEIGHT)? {
            if *weight < self.below {
                let survives = uniform(&mut rng) < self.survival;
                *weight = if survives { *weight / self.survival } else { 0.0 };
            }
        }
        Ok(())
    }
}

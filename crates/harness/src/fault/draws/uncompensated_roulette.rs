use crate::fault::{BlockContext, Injection, Target};
use freepath_draws::random::uniform;
use freepath_draws::{Draws, MissingColumn, column};
use freepath_estimators::ParameterError;
use freepath_estimators::parameter::{finite, require};

/// Estimates below a threshold die by roulette, and the survivors are not raised (Chunky, issue 1018; LuxCore, commit
/// 44fc5bf1f).
///
/// ```text
/// right: w := w / p on survival;   wrong: w := w
/// ```
///
/// Shows in: the mean; hardly where the threshold is far below it.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UncompensatedRoulette {
    /// Estimates below it play.
    below: f64,
    /// Probability of survival.
    survival: f64,
}

impl Injection for UncompensatedRoulette {
    fn check(&self) -> Result<(), ParameterError> {
        finite("below", self.below)?;
        let allowed = self.survival > 0.0 && self.survival < 1.0;
        require(allowed, "survival", self.survival, "between 0 and 1").map(drop)
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.draws_estimates()
    }
    fn corrupt_draws(&self, context: &BlockContext, draws: &mut Draws) -> Result<(), MissingColumn> {
        let mut rng = context.rng();
        for weight in draws.f64_mut(column::WEIGHT)? {
            if *weight < self.below && uniform(&mut rng) >= self.survival {
                *weight = 0.0;
            }
        }
        Ok(())
    }
}

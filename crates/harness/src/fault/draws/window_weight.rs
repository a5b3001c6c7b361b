use crate::fault::{BlockContext, Injection, Target};
use freepath_draws::random::uniform;
use freepath_draws::{Draws, MissingColumn, column};
use freepath_estimators::ParameterError;
use freepath_estimators::parameter::positive;

/// Survivors of a roulette get a weight that was not scaled with the window, and a weight above it always survives and is
/// cut down (OpenMC, issue 3511).
///
/// ```text
/// right: p = w / w_s, w := w_s;   wrong: p = min(1, w / w_s), w := w_s where w_s < w
/// ```
///
/// Shows in: the mean; nowhere where no weight below the window exceeds w_s.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WindowWeight {
    /// Estimates below it play.
    below: f64,
    /// w_s.
    survivor: f64,
}

impl Injection for WindowWeight {
    fn check(&self) -> Result<(), ParameterError> {
        positive("below", self.below)?;
        positive("survivor", self.survivor).map(drop)
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.draws_estimates()
    }
    fn corrupt_draws(&self, context: &BlockContext, draws: &mut Draws) -> Result<(), MissingColumn> {
        let mut rng = context.rng();
        for weight in draws.f64_mut(column::WEIGHT)? {
            if *weight < self.below {
                let survives = uniform(&mut rng) * self.survivor < *weight;
                *weight = if survives { self.survivor } else { 0.0 };
            }
        }
        Ok(())
    }
}

use crate::fault::{BlockContext, Injection, Target};
use freepath_draws::{Draws, MissingColumn, column};
use freepath_estimators::ParameterError;
use freepath_estimators::parameter::positive;

/// A transmittance below a threshold is taken for none, without roulette (instant-ngp, issue 384; gsplat, issue 541; Cycles,
/// commit 6b34e594d).
///
/// ```text
/// right: roulette;   wrong: T := 0 where T < below
/// ```
///
/// Shows in: the mean, all of it where T is below the threshold; hardly where T is far above.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TruncatedWeight {
    /// Estimates below it become 0.
    below: f64,
}

impl Injection for TruncatedWeight {
    fn check(&self) -> Result<(), ParameterError> {
        positive("below", self.below).map(drop)
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.draws_estimates()
    }
    fn corrupt_draws(&self, _context: &BlockContext, draws: &mut Draws) -> Result<(), MissingColumn> {
        draws
            .f64_mut(column::WEIGHT)?
            .iter_mut()
            .filter(|weight| **weight < self.below)
            .for_each(|weight| *weight = 0.0);
        Ok(())
    }
}

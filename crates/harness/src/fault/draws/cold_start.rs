use crate::fault::{BlockContext, Injection, Target};
use freepath_draws::{Draws, MissingColumn, column};
use freepath_estimators::ParameterError;
use freepath_estimators::parameter::require;

/// The first draws of a start come before the tables that they need, and find the ray empty (a typical slip).
///
/// ```text
/// right: no draw before the tables are there;   wrong: the first `draws` of a start escape, or are estimates of 1
/// ```
///
/// Shows in: the law or the mean of stage 1 alone, since stage 2 is later draws of the same start; little where few draws are early.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ColdStart {
    /// How many draws come too early.
    draws: u64,
}

impl Injection for ColdStart {
    fn check(&self) -> Result<(), ParameterError> {
        require(self.draws >= 1, "draws", self.draws, "at least 1").map(drop)
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.crosses_a_medium()
    }
    fn corrupt_draws(&self, context: &BlockContext, draws: &mut Draws) -> Result<(), MissingColumn> {
        let early = self.draws.saturating_sub(context.first);
        let early = if early < draws.rows() as u64 { early as usize } else { draws.rows() };
        if let Ok(collisions) = draws.u32_mut(column::COLLISIONS) {
            collisions[..early].fill(0);
        }
        match draws.f64_mut(column::T) {
            Ok(t) => t[..early].fill(f64::INFINITY),
            Err(MissingColumn { .. }) => draws.f64_mut(column::WEIGHT)?[..early].fill(1.0),
        }
        Ok(())
    }
}

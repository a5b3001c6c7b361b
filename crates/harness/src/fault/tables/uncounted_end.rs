use crate::fault::Injection;
use freepath_estimators::Capability;
use freepath_estimators::walk::System;

/// The state where a walk ends is not counted (a typical slip).
/// The loop is left before it scores.
///
/// ```text
/// right: visits up to the last state;   wrong: up to the one before it
/// ```
///
/// Shows in: the mean, x (1 - p*) of a chain; nowhere where no walk ends in a state that counts.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UncountedEnd {}

impl Injection for UncountedEnd {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::VisitScore]
    }
    fn alter_walks(&self, system: System) -> Result<System, String> {
        Ok(system.with_walkers(|walker| walker.last.fill(0.0)))
    }
}

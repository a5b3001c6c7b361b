use crate::fault::Injection;
use freepath_estimators::Capability;
use freepath_estimators::walk::System;

/// The state where a walk starts is not counted (a typical slip).
/// The loop takes a step before it scores.
///
/// ```text
/// right: visits from the first state on;   wrong: from the second on
/// ```
///
/// Shows in: the mean, x - p0 of a chain; nowhere where no walk starts in a state that counts.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UncountedStart {}

impl Injection for UncountedStart {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::VisitScore]
    }
    fn alter_walks(&self, system: System) -> Result<System, String> {
        Ok(system.with_walkers(|walker| walker.first = 0.0))
    }
}

use crate::fault::Injection;
use freepath_estimators::Capability;
use freepath_estimators::walk::System;

/// A walk scores its source where it ends, and does not divide by the probability to end there (a typical slip).
///
/// ```text
/// right: X = W b / p*;   wrong: X = W b
/// ```
///
/// Shows in: the mean, x p* for x of a chain; nowhere where a walk always ends.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ForgottenAbsorption {}

impl Injection for ForgottenAbsorption {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::EndScore]
    }
    fn alter_walks(&self, system: System) -> Result<System, String> {
        Ok(system.with_walkers(|walker| walker.end.clone_from(&walker.last)))
    }
}

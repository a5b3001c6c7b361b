use crate::fault::{Injection, Overlay, WalkContext};
use freepath_estimators::parameter::positive;
use freepath_estimators::{Capability, ParameterError};

/// A small extinction is taken for none, whatever the length of the ray (Cycles, commit e9d7d473b).
///
/// ```text
/// right: no cut-off, or one on tau;   wrong: mu := 0 where mu < below
/// ```
///
/// Shows in: the escape atom for small mu and long rays; nowhere where mu is near 1.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DensityCutoff {
    /// In 1/length.
    below: f64,
}

struct Cutoff(f64);

impl Overlay for Cutoff {
    fn answer(&self, _t: f64, mu: f64) -> f64 {
        if mu < self.0 { 0.0 } else { mu }
    }
}

impl Injection for DensityCutoff {
    fn check(&self) -> Result<(), ParameterError> {
        positive("below", self.below).map(drop)
    }
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::LookUps]
    }
    fn overlay<'a>(&'a self, _context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Cutoff(self.below)))
    }
}

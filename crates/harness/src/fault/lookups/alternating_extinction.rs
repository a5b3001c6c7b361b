use super::missing_scale::Times;
use crate::fault::{Injection, Overlay, RayView, WalkContext};
use freepath_estimators::parameter::require;
use freepath_estimators::{Capability, ParameterError};

/// Blocks of draws see the extinction too large and too small in turn: a table that each worker makes by itself (a typical slip).
///
/// ```text
/// right: mu;   wrong: mu (1 + share) in even blocks, mu (1 - share) in odd ones
/// ```
///
/// Shows in: sums over blocks, which scatter too widely. The law of all draws is off by share^2 alone.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AlternatingExtinction {
    /// The share of mu that is added or taken away.
    share: f64,
}

impl Injection for AlternatingExtinction {
    fn check(&self) -> Result<(), ParameterError> {
        require(self.share > 0.0 && self.share < 1.0, "share", self.share, "between 0 and 1").map(drop)
    }
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::LookUps]
    }
    fn alter_ray(&self, ray: &mut RayView) {
        ray.majorants = ray.majorants.map(|mu| (1.0 + self.share) * mu);
    }
    fn overlay<'a>(&'a self, context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        let sign = if context.key.block.is_multiple_of(2) { 1.0 } else { -1.0 };
        Some(Box::new(Times(1.0 + sign * self.share)))
    }
}

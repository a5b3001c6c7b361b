use super::next_cell::Next;
use crate::fault::{Injection, Overlay, Target, WalkContext};
use freepath_estimators::parameter::require;
use freepath_estimators::{Capability, ParameterError};

/// The walk through the cells is off by one where the direction is negative (fast_voxel_traversal, issue 7).
///
/// ```text
/// right: the first face is i + 1 for d > 0 and i for d < 0;   wrong: i - 1 for d < 0, so that cells carry the next one's mu
/// ```
///
/// Shows in: the law of t along reversed rays; nowhere for positive directions.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BackwardCells {
    /// The ray's direction along the cells: not 0. Reverse the medium for a negative one.
    along: f64,
}

impl Injection for BackwardCells {
    fn check(&self) -> Result<(), ParameterError> {
        let allowed = self.along.is_finite() && self.along != 0.0;
        require(allowed, "along", self.along, "finite and not 0").map(drop)
    }
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::LookUps]
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.has_constant_cells()
    }
    fn overlay<'a>(&'a self, context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        let backward = self.along < 0.0;
        backward.then(|| Box::new(Next(context.medium)) as Box<dyn Overlay + 'a>)
    }
}

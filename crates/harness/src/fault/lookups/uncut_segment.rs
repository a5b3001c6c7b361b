use crate::fault::{Injection, RayView};
use freepath_estimators::parameter::not_negative;
use freepath_estimators::{Capability, ParameterError};

/// The last cell is not cut where the ray ends (pbrt-v4, commit 415c0538).
///
/// ```text
/// right: cell end = min(t_max, next crossing);   wrong: cell end = next crossing
/// ```
///
/// Shows in: look-ups and collisions beyond the end, the escape atom; nowhere where the ray ends at a cell's face.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UncutSegment {
    /// The length by which the last cell goes on beyond the end.
    by: f64,
}

impl Injection for UncutSegment {
    fn check(&self) -> Result<(), ParameterError> {
        not_negative("by", self.by).map(drop)
    }
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::LookUps]
    }
    fn alter_ray(&self, ray: &mut RayView) {
        let (end, beyond) = (ray.length, ray.length + self.by);
        ray.length = beyond;
        ray.majorants = ray.majorants.map_ends(|t| if t < end { t } else { beyond });
    }
}

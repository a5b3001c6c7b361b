use crate::fault::{Injection, RayView};
use freepath_estimators::parameter::require;
use freepath_estimators::{Capability, ParameterError};

/// A shadow ray ends a little before its end (Mitsuba 3, commit 9b2212891).
///
/// ```text
/// right: tau(0, L);   wrong: tau(0, L (1 - share))
/// ```
///
/// Shows in: the mean, in T(0, L) = T(0, s) T(s, L), and in collisions that are missing at the end.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShortenedSegment {
    /// The part that is cut off, as a share of the length.
    share: f64,
}

impl Injection for ShortenedSegment {
    fn check(&self) -> Result<(), ParameterError> {
        require(self.share > 0.0 && self.share < 1.0, "share", self.share, "between 0 and 1").map(drop)
    }
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::LookUps]
    }
    fn alter_ray(&self, ray: &mut RayView) {
        let end = ray.length * (1.0 - self.share);
        ray.length = end;
        ray.majorants = ray.majorants.map_ends(|t| if t > end { end } else { t });
        ray.breaks.retain(|&t| t < end);
    }
}

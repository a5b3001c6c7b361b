use crate::fault::Injection;
use freepath_estimators::Capability;
use freepath_estimators::integral::Sampled;

/// The uniforms may be 1, and the draw the end of the domain (a typical slip).
///
/// ```text
/// right: u in [0, 1);   wrong: u in [0, 1], and a division by p = 0 where the density vanishes at the end
/// ```
///
/// Shows in: an infinite estimate once in 2^52 draws, and at once under scripted uniforms; nowhere where p is not 0 at the end.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ClosedInterval {}

impl Injection for ClosedInterval {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::Density]
    }
    fn divide(&self, sampled: &Sampled, weight: f64) -> f64 {
        // the last of the uniforms of 52 bits stands for 1
        if sampled.u < 1.0 - f64::EPSILON { weight } else { sampled.f / (sampled.density)(sampled.end) }
    }
}

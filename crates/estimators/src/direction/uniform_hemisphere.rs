use super::axial::{self, Axial, Tilt};
use super::frame::dot;
use super::{DirectionSampler, Drawn, Vector};
use freepath_draws::{Draws, Streams};
use std::f64::consts::PI;

/// Directions that are uniform over the hemisphere about the normal.
///
/// ```text
/// cos = 1 - u,   phi = 2 pi v,   pdf = 1/(2 pi)
/// ```
///
/// Target: the uniform density over the hemisphere.
/// Range:  the hemisphere; cos is never 0, since u is below 1.
/// Cost:   two uniforms.
/// Needs:  a unit normal.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UniformHemisphere {}

impl Axial for UniformHemisphere {
    #[inline(always)]
    fn tilt(&self, u: f64) -> Tilt {
        Tilt::of_depth(u)
    }
    #[inline(always)]
    fn density(&self, _: f64) -> f64 {
        0.5 / PI
    }
}

impl DirectionSampler for UniformHemisphere {
    fn sample(&self, normal: Vector, rng: &mut dyn rand::Rng) -> Drawn {
        axial::sample(self, normal, rng)
    }
    fn sample_block(&self, normal: Vector, streams: &Streams, out: &mut Draws) {
        axial::sample_block(self, normal, streams, out);
    }
    fn pdf(&self, normal: Vector, w: Vector) -> f64 {
        if dot(normal, w) > 0.0 { self.density(0.0) } else { 0.0 }
    }
}

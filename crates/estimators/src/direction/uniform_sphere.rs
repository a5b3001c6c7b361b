use super::axial::{self, Axial, Tilt};
use super::{DirectionSampler, Drawn, Vector};
use freepath_draws::{Draws, Streams};
use std::f64::consts::PI;

/// Directions that are uniform over the sphere (Archimedes: a zone has the area of its height).
///
/// ```text
/// cos = 1 - 2 u,   phi = 2 pi v,   pdf = 1/(4 pi)
/// ```
///
/// Target: the uniform density over the sphere; the normal is where u = 0 points to.
/// Range:  the sphere.
/// Cost:   two uniforms.
/// Needs:  nothing.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UniformSphere {}

impl Axial for UniformSphere {
    #[inline(always)]
    fn tilt(&self, u: f64) -> Tilt {
        Tilt::of_depth(2.0 * u)
    }
    #[inline(always)]
    fn density(&self, _: f64) -> f64 {
        0.25 / PI
    }
}

impl DirectionSampler for UniformSphere {
    fn sample(&self, normal: Vector, rng: &mut dyn rand::Rng) -> Drawn {
        axial::sample(self, normal, rng)
    }
    fn sample_block(&self, normal: Vector, streams: &Streams, out: &mut Draws) {
        axial::sample_block(self, normal, streams, out);
    }
    fn pdf(&self, _: Vector, _: Vector) -> f64 {
        self.density(0.0)
    }
}

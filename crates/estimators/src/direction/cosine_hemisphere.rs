use super::axial::{self, Axial, Tilt};
use super::frame::dot;
use super::{DirectionSampler, Drawn, Vector};
use freepath_draws::{Draws, Streams};
use std::f64::consts::PI;

/// Directions as frequent as their cosine to the normal: a uniform point of the disk, lifted to the hemisphere (Malley).
///
/// ```text
/// sin = sqrt(u),   cos = sqrt(1 - u),   phi = 2 pi v,   pdf = cos/pi
/// ```
///
/// Target: the density cos/pi over the hemisphere, Lambert's.
/// Range:  the hemisphere; cos is never 0, since u is below 1.
/// Cost:   two uniforms.
/// Needs:  a unit normal.
/// Source: Pharr, Jakob and Humphreys 2023, Physically Based Rendering, section A.5.3.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CosineHemisphere {}

impl Axial for CosineHemisphere {
    #[inline(always)]
    fn tilt(&self, u: f64) -> Tilt {
        Tilt { cos: (1.0 - u).sqrt(), sin: u.sqrt() }
    }
    #[inline(always)]
    fn density(&self, cos: f64) -> f64 {
        cos / PI
    }
}

impl DirectionSampler for CosineHemisphere {
    fn sample(&self, normal: Vector, rng: &mut dyn rand::Rng) -> Drawn {
        axial::sample(self, normal, rng)
    }
    fn sample_block(&self, normal: Vector, streams: &Streams, out: &mut Draws) {
        axial::sample_block(self, normal, streams, out);
    }
    fn pdf(&self, normal: Vector, w: Vector) -> f64 {
        let cos = dot(normal, w);
        if cos > 0.0 { self.density(cos) } else { 0.0 }
    }
}

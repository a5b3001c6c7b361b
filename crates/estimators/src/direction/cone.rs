use super::axial::{self, Axial, Tilt};
use super::frame::depth;
use super::{DirectionSampler, Drawn, Vector};
use crate::parameter::{ParameterError, require};
use freepath_draws::{Draws, Streams};
use std::f64::consts::{PI, TAU};

/// Directions that are uniform in the cone of a half angle about the normal.
///
/// ```text
/// h = 2 sin(half_angle/2)^2,   cos = 1 - h u,   sin = sqrt(h u (2 - h u)),   phi = 2 pi v,   pdf = 1/(2 pi h)
/// ```
///
/// Target: the uniform density over the cap, whose height is h = 1 - cos(half_angle).
/// Range:  the cap.
/// Cost:   two uniforms.
/// Needs:  a unit normal. h is no difference of numbers near 1: that loses the small cones (pbrt-v3, issue 212).
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cone {
    /// The angle from the normal to the rim, in radians: from 1e-9 to pi.
    #[schemars(range(min = 1e-9, max = std::f64::consts::PI))]
    pub half_angle: f64,
}

impl Cone {
    /// The height of the cap.
    #[inline(always)]
    fn height(&self) -> f64 {
        let half = libm::sin(0.5 * self.half_angle);
        2.0 * half * half
    }
}

/// A cap of this height.
struct Cap {
    height: f64,
}

impl Axial for Cap {
    #[inline(always)]
    fn tilt(&self, u: f64) -> Tilt {
        Tilt::of_depth(self.height * u)
    }
    #[inline(always)]
    fn density(&self, _: f64) -> f64 {
        1.0 / (TAU * self.height)
    }
}

impl DirectionSampler for Cone {
    fn sample(&self, normal: Vector, rng: &mut dyn rand::Rng) -> Drawn {
        axial::sample(&Cap { height: self.height() }, normal, rng)
    }
    fn sample_block(&self, normal: Vector, streams: &Streams, out: &mut Draws) {
        axial::sample_block(&Cap { height: self.height() }, normal, streams, out);
    }
    fn pdf(&self, normal: Vector, w: Vector) -> f64 {
        let cap = Cap { height: self.height() };
        if depth(normal, w) <= cap.height { cap.density(1.0) } else { 0.0 }
    }
    fn accepts(&self) -> Result<(), ParameterError> {
        let angle = self.half_angle;
        require(angle >= super::law::LEAST_ANGLE && angle <= PI, "half_angle", angle, "from 1e-9 to pi").map(drop)
    }
}

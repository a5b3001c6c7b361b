//! Directions whose density depends on the angle to the normal alone: each from two uniforms, one by one or many at once.

use super::frame::Frame;
use super::{Drawn, Vector, write};
use freepath_draws::math::sin2pi;
use freepath_draws::random::uniform;
use freepath_draws::{Draws, Streams, simd};

/// The angle to the normal.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tilt {
    pub(super) cos: f64,
    pub(super) sin: f64,
}

impl Tilt {
    /// The one of which 1 - cos is `depth`: the sine has all of its digits at small angles, too.
    #[inline(always)]
    pub(super) fn of_depth(depth: f64) -> Self {
        Self { cos: 1.0 - depth, sin: (depth * (2.0 - depth)).sqrt() }
    }
}

/// The map of such a sampler from one uniform to an angle, and the density that goes with it.
pub(super) trait Axial {
    /// The angle of a uniform in [0, 1).
    fn tilt(&self, u: f64) -> Tilt;
    /// The density at a cosine inside the support, 1/steradian.
    fn density(&self, cos: f64) -> f64;
}

/// The direction of two uniforms.
#[inline(always)]
fn direction(axial: &impl Axial, frame: &Frame, [u, v]: [f64; 2]) -> Drawn {
    let Tilt { cos, sin } = axial.tilt(u);
    let w = frame.to_world([sin * sin2pi(v + 0.25), sin * sin2pi(v), cos]);
    Drawn { w, pdf: axial.density(cos) }
}

/// One direction.
pub(super) fn sample(axial: &impl Axial, normal: Vector, rng: &mut dyn rand::Rng) -> Drawn {
    let uniforms = [uniform(rng), uniform(rng)];
    direction(axial, &Frame::about(normal), uniforms)
}

/// Directions computed at a time.
const TILE: usize = 256;

/// One direction for each row of `out`: bit for bit those that [`sample`] draws one after another.
pub(super) fn sample_block(axial: &impl Axial, normal: Vector, streams: &Streams, out: &mut Draws) {
    let (mut rng, frame) = (streams.rng(), Frame::about(normal));
    let mut drawn = [Drawn { w: [0.0; 3], pdf: 0.0 }; TILE];
    for first in (0..out.rows()).step_by(TILE) {
        let rows = if out.rows() - first < TILE { out.rows() - first } else { TILE };
        let mut uniforms = [[0.0; 2]; TILE];
        uniforms[..rows].iter_mut().for_each(|pair| *pair = [uniform(&mut rng), uniform(&mut rng)]);
        simd::dispatch(
            #[inline(always)]
            || {
                for (drawn, &pair) in drawn.iter_mut().zip(&uniforms) {
                    *drawn = direction(axial, &frame, pair);
                }
            },
        );
        write(&drawn[..rows], first, out);
    }
}

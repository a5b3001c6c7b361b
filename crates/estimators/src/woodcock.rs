//! The tentative-collision walk that the null-collision family shares: one walk at a time for any generator
//! ([`walk`]), and a tile of walks side by side ([`walks`]).
//!
//! Tentative collisions are a Poisson process of the segment's rate (Woodcock et al. 1965; Coleman 1968). What a
//! tentative collision means is a [`CollisionRule`]: delta tracking stops there with probability mu / rate, ratio
//! tracking multiplies a weight, and so on. Every walk that is started is finished: nothing ever stops at a count of
//! steps, which would favour short walks.
//!
//! A rule of one's own has both drivers at once:
//!
//! ```
//! use freepath_draws::{Draws, Key, Row, Streams, column};
//! use freepath_estimators::medium::Linear;
//! use freepath_estimators::woodcock::{Collision, CollisionRule, Form, Rates, walks};
//! use freepath_estimators::{Extinction, Medium};
//!
//! /// Ratio tracking.
//! struct Ratio;
//!
//! impl CollisionRule for Ratio {
//!     type State = f64;
//!     const DRAWS: bool = false;
//!     #[inline(always)]
//!     fn start(&self) -> f64 {
//!         1.0
//!     }
//!     #[inline(always)]
//!     fn collide(&self, weight: f64, at: Collision) -> (f64, bool) {
//!         (weight * (1.0 - at.mu * at.mfp), false)
//!     }
//!     #[inline(always)]
//!     fn weight(&self, weight: f64, _escaped: bool) -> f64 {
//!         weight
//!     }
//! }
//!
//! let medium = Linear::new(0.5, 2.0, 1.5)?;
//! let mut draws = Draws::new(&Row::new().with_f64(column::WEIGHT), 16_384);
//! let streams = Streams::new(Key { seed: 1, subject: 2, block: 3 });
//! walks(&Ratio, &Rates::of(medium.majorants()), Form::Carry, &medium, &streams, &mut draws);
//!
//! let mean = draws.f64(column::WEIGHT)?.iter().sum::<f64>() / 16_384.0;
//! let transmittance = (-medium.tau(medium.length())).exp();
//! assert!((mean / transmittance - 1.0).abs() < 0.05);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::extinction::Extinction;
use crate::path::FreePath;
use freepath_draws::random::{exponential, uniform};
use freepath_draws::{Draws, PathColumns, Streams};

mod rates;
mod tile;

pub use rates::{RateSegment, Rates};
pub use tile::walks;

/// A tentative collision: where, with what, and a uniform if the rule asked for one.
#[derive(Clone, Copy, Debug)]
pub struct Collision {
    /// The place.
    pub t: f64,
    /// Extinction there.
    pub mu: f64,
    /// 1 / rate of the segment.
    pub mfp: f64,
    /// The segment's control extinction.
    pub control: f64,
    /// A uniform in [0, 1) if [`CollisionRule::DRAWS`], else 0.
    pub u: f64,
}

/// The rule of one member of the family at a tentative collision.
///
/// Every method must be `#[inline(always)]` and should be free of branches: they run once for each lane of a tile.
pub trait CollisionRule {
    /// The state that a walk carries: nothing, a weight, a weight and a sum.
    type State: Copy;
    /// Does `collide` read a uniform?
    const DRAWS: bool;
    /// The state of a new walk.
    fn start(&self) -> Self::State;
    /// The state after a tentative collision, and whether the walk stops there.
    fn collide(&self, state: Self::State, at: Collision) -> (Self::State, bool);
    /// The weight of a finished walk.
    fn weight(&self, state: Self::State, escaped: bool) -> f64;
}

/// The treatment of the rest of a walk's optical distance at the end of a segment. Both are exact, since the exponential
/// law has no memory.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, serde::Serialize, schemars::JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum Form {
    /// Forget it and draw afresh in the next segment (Woodcock et al. 1965; pbrt-v4).
    #[default]
    Restart,
    /// Carry it into the next segment (Szirmay-Kalos et al. 2011).
    Carry,
}

/// One walk, with any generator.
pub fn walk<R: CollisionRule>(
    rule: &R,
    rates: &Rates,
    form: Form,
    medium: &dyn Extinction,
    rng: &mut dyn rand::Rng,
) -> FreePath {
    let (mut state, mut t, mut collisions) = (rule.start(), 0.0, 0);
    let (mut segment, mut end, mut mfp, mut control) = (0, rates.end(0), rates.mfp(0), rates.control(0));
    let (t, escaped) = 'walk: loop {
        t += exponential(rng) * mfp;
        while !(t < end) {
            if segment + 1 == rates.len() {
                break 'walk (f64::INFINITY, true);
            }
            let depth = match form {
                Form::Carry => (t - end) * rates.rate(segment),
                Form::Restart => exponential(rng),
            };
            segment += 1;
            t = end + depth * rates.mfp(segment);
            (end, mfp, control) = (rates.end(segment), rates.mfp(segment), rates.control(segment));
        }
        let u = if R::DRAWS { uniform(rng) } else { 0.0 };
        let mu = medium.mu(t);
        let at = Collision { t, mu, mfp, control, u };
        let (next, stop) = rule.collide(state, at);
        (state, collisions) = (next, collisions + 1);
        if stop {
            break (t, false);
        }
    };
    let weight = rule.weight(state, escaped);
    FreePath { t, weight, collisions }
}

/// The provided block of a scalar sampler: as many calls of `draw` as `out` has rows.
pub(crate) fn one_by_one(
    streams: &Streams,
    out: &mut Draws,
    mut draw: impl FnMut(&mut dyn rand::Rng) -> FreePath,
) {
    let (mut rng, mut columns) = (streams.rng(), PathColumns::of(out));
    for row in 0..columns.rows() {
        let path = draw(&mut rng);
        columns.put(row, path.t, path.weight, path.collisions);
    }
}

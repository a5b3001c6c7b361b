//! The count of the draws in an interval, or in several, against its binomial law.

use crate::special::{binomial_cdf, binomial_sf, likelihood_ratio};

/// The probability of an interval.
#[derive(Clone, Copy, Debug)]
pub(super) struct Expected {
    /// The probability.
    pub(super) mass: f64,
    /// The most by which it may be off.
    pub(super) unknown: f64,
}

/// A count that is off, held against the nearest probability that may be right.
#[derive(Clone, Copy, Debug)]
pub(super) struct Off {
    draws: u64,
    seen: u64,
    nearest: f64,
    many: bool,
    ratio: f64,
}

impl Off {
    /// `seen` of `draws` where `expected` is the probability; NaN stays.
    pub(super) fn new(draws: u64, seen: u64, expected: Expected) -> Self {
        let Expected { mass, unknown } = expected;
        let (low, high) = (mass - unknown, mass + unknown);
        let (low, high) = (if low < 0.0 { 0.0 } else { low }, if high > 1.0 { 1.0 } else { high });
        let share = seen as f64 / draws as f64;
        let many = share > mass;
        let nearest = if many { high } else { low };
        let inside = if many { share <= high } else { share >= low };
        let nearest = if inside { share } else { nearest };
        Self { draws, seen, nearest, many, ratio: likelihood_ratio(draws as f64, seen as f64, nearest) }
    }

    /// True if there are more than expected.
    pub(super) fn many(&self) -> bool {
        self.many
    }

    /// n KL(O / n || P): the p-value is at most 2 exp of minus it (Chernoff 1952), and hardly less.
    pub(super) fn ratio(&self) -> f64 {
        self.ratio
    }

    /// Twice the tail on its side.
    pub(super) fn p(&self) -> f64 {
        let Self { draws, seen, nearest, many, .. } = *self;
        let tail = if many { binomial_sf(draws, nearest, seen) } else { binomial_cdf(draws, nearest, seen) };
        2.0 * tail
    }
}

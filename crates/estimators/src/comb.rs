//! The comb of equidistant points that ray marching looks at: one in each step, at the same fraction of it.

use crate::extinction::Extinction;
use crate::parameter::{self, ParameterError};

/// The most steps of a ray.
const MOST_STEPS: usize = 100_000_000;

/// Points of one look-up tile.
pub(crate) const TILE: usize = 256;

/// A number of steps, 1 to 100,000,000.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, serde::Deserialize, serde::Serialize, schemars::JsonSchema,
)]
#[serde(try_from = "usize", into = "usize")]
pub struct Steps(usize);

impl Steps {
    /// So many steps.
    ///
    /// # Errors
    /// If there are none, or more than 100,000,000.
    pub fn new(steps: usize) -> Result<Self, ParameterError> {
        let allowed = steps >= 1 && steps <= MOST_STEPS;
        parameter::require(allowed, "steps", steps, &format!("1 to {MOST_STEPS}")).map(Self)
    }

    /// Their number.
    #[inline(always)]
    #[must_use]
    pub fn get(self) -> usize {
        self.0
    }
}

impl TryFrom<usize> for Steps {
    type Error = ParameterError;

    fn try_from(steps: usize) -> Result<Self, ParameterError> {
        Self::new(steps)
    }
}

impl From<Steps> for usize {
    fn from(steps: Steps) -> Self {
        steps.0
    }
}

/// The steps laid over one ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Comb {
    pub(crate) steps: usize,
    /// The length of a step.
    pub(crate) h: f64,
    length: f64,
}

impl Comb {
    /// `steps` equal steps along the ray of `medium`.
    #[inline(always)]
    pub(crate) fn new(steps: Steps, medium: &(impl Extinction + ?Sized)) -> Self {
        let (steps, length) = (steps.get(), medium.length());
        let h = length / steps as f64;
        Self { steps, h, length }
    }

    /// The point at the fraction `v` of step `j`; rounding never takes it past the end of the ray.
    #[inline(always)]
    pub(crate) fn at(&self, j: usize, v: f64) -> f64 {
        let t = self.h * (j as f64 + v);
        if t > self.length { self.length } else { t } // NaN stays
    }

    /// Optical depth by the comb at the fractions that `v` gives, one call for each step in order.
    pub(crate) fn depth(&self, medium: &(impl Extinction + ?Sized), mut v: impl FnMut() -> f64) -> f64 {
        let (mut t, mut mu, mut sum) = ([0.0; TILE], [0.0; TILE], Compensated::<1>::default());
        for first in (0..self.steps).step_by(TILE) {
            let n = TILE.min(self.steps - first);
            for (i, t) in t[..n].iter_mut().enumerate() {
                *t = self.at(first + i, v());
            }
            medium.mu_tile(&t[..n], &mut mu[..n]);
            sum.add([freepath_draws::math::sum(&mu[..n])]);
        }
        self.h * sum.total[0]
    }

    /// The fractions of a step where some point of the comb meets one of the `breaks`: increasing, inside (0, 1).
    pub(crate) fn jumps(&self, breaks: &[f64]) -> Vec<f64> {
        let fraction = |b: &f64| b / self.h - (b / self.h).floor();
        let inner = |&v: &f64| v > 1e-12 && v < 1.0 - 1e-12;
        let mut jumps: Vec<f64> = breaks.iter().map(fraction).filter(inner).collect();
        jumps.sort_by(f64::total_cmp);
        jumps.dedup_by(|b, a| *b - *a < 1e-12);
        jumps
    }
}

/// Sums whose rounding does not grow with the number of terms (Kahan 1965).
pub(crate) struct Compensated<const N: usize> {
    pub(crate) total: [f64; N],
    lost: [f64; N],
}

impl<const N: usize> Default for Compensated<N> {
    #[inline(always)]
    fn default() -> Self {
        Self { total: [0.0; N], lost: [0.0; N] }
    }
}

impl<const N: usize> Compensated<N> {
    /// Adds one term to each sum.
    #[inline(always)]
    pub(crate) fn add(&mut self, terms: [f64; N]) {
        for ((total, lost), term) in self.total.iter_mut().zip(&mut self.lost).zip(terms) {
            let y = term - *lost;
            let next = *total + y;
            *lost = (next - *total) - y;
            *total = next;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::medium::Constant;

    #[test]
    fn a_step_count_out_of_range_is_refused_by_name() {
        let refused = Steps::new(0).unwrap_err().to_string();
        assert_eq!(refused, "steps must be 1 to 100000000, not 0");
        assert!(Steps::new(MOST_STEPS + 1).is_err() && Steps::new(MOST_STEPS).is_ok());
    }

    #[test]
    fn the_depth_of_many_steps_keeps_its_digits() {
        let medium = Constant::new(1.3, 2.0).unwrap();
        for steps in [1, 3, 1000, 999_999] {
            let comb = Comb::new(Steps::new(steps).unwrap(), &medium);
            assert!((comb.depth(&medium, || 0.25) - 2.6).abs() < 1e-14, "{steps}");
        }
    }

    #[test]
    fn no_point_lies_beyond_the_ray() {
        let medium = Constant::new(1.3, 2.1).unwrap();
        for steps in 1..2000 {
            let comb = Comb::new(Steps::new(steps).unwrap(), &medium);
            assert!(comb.at(steps - 1, 1.0 - 2f64.powi(-52)) <= 2.1);
        }
    }
}

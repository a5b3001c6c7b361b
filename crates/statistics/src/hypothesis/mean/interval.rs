use super::bernstein::bernstein_width;
use super::difference::{ROUNDING, bias};
use super::hall::corrected_t;
use super::method::{Method, method};
use crate::hypothesis::mean_claim::MeanClaim;
use crate::larger::larger;
use crate::special::{clopper_pearson, normal_quantile};
use crate::tally::PowerSums;

/// An interval for the bias at the reporting level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The method that made it.
    pub method: Method,
    /// Limits of the bias.
    pub low: f64,
    /// As `low`.
    pub high: f64,
}

impl Interval {
    /// The largest |bias| that the interval still allows.
    #[must_use]
    pub fn bound(&self) -> f64 {
        let (low, high) = (self.low.abs(), self.high.abs());
        larger(low, high)
    }
}

/// An interval for the bias at confidence 1 - `level`, by the method that [`mean`](super::mean()) takes.
#[must_use]
pub fn interval_at(sums: &PowerSums, claim: &MeanClaim, level: f64) -> Interval {
    interval(sums, claim, method(sums, claim), level)
}

/// An interval for the bias by `method`.
pub(super) fn interval(sums: &PowerSums, claim: &MeanClaim, method: Method, level: f64) -> Interval {
    let (bias, n) = (bias(sums, claim), sums.n as f64);
    let (error, z) = ((sums.variance() / n).sqrt(), normal_quantile(0.5 * level));
    let about = |half: f64| Interval { method, low: bias - half, high: bias + half };
    match (method, claim.range) {
        (Method::Binomial, _) => {
            let (low, high) = clopper_pearson(sums.n, sums.ones, level);
            Interval { method, low: low - claim.expected, high: high - claim.expected }
        }
        (Method::Exact, _) => about(ROUNDING * claim.expected.abs() + claim.slack),
        (Method::EmpiricalBernstein, Some(range)) => about(bernstein_width(sums.variance(), n, range, level)),
        (Method::None | Method::AllOnes | Method::BatchMeans, _) | (Method::EmpiricalBernstein, None) => {
            about(f64::INFINITY)
        }
        (Method::StudentT, _) => about(z * error),
        (Method::SkewnessCorrected, _) => corrected_limits(sums, z, bias, about(z * error)),
    }
}

/// `symmetric` with the limits at which [`corrected_p`] reaches the normal score z.
fn corrected_limits(sums: &PowerSums, z: f64, bias: f64, symmetric: Interval) -> Interval {
    let (n, error) = (sums.n as f64, (sums.variance() / sums.n as f64).sqrt());
    let t = |score| corrected_t(score, sums.skewness(), n);
    Interval { low: bias - t(z) * error, high: bias - t(-z) * error, ..symmetric }
}

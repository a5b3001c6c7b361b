use super::difference::bias;
use super::method::within;
use crate::evidence::REPORTING_LEVEL;
use crate::hypothesis::mean_claim::MeanClaim;
use crate::tally::PowerSums;

/// The level at which the empirical Bernstein interval just reaches the excess:
/// |excess| = sqrt(2 V L / n) + 7 R L / (3 (n - 1)), L = ln(4 / p).
pub(super) fn bernstein_p(sums: &PowerSums, claim: &MeanClaim, excess: f64) -> f64 {
    let Some((low, high)) = claim.range else {
        return f64::NAN;
    };
    let n = sums.n as f64;
    let (a, b) = (7.0 * (high - low) / (3.0 * (n - 1.0)), (2.0 * sums.variance() / n).sqrt());
    if excess == 0.0 {
        return 1.0; // else 0 / 0 without variance
    }
    let root = 2.0 * excess.abs() / (b + (b * b + 4.0 * a * excess.abs()).sqrt());
    let p = 4.0 * libm::exp(-root * root);
    if p > 1.0 { 1.0 } else { p }
}

/// Half the interval of `n` draws at confidence 1 - `level`.
pub(super) fn bernstein_width(variance: f64, n: f64, (low, high): (f64, f64), level: f64) -> f64 {
    let l = libm::log(4.0 / level);
    (2.0 * variance * l / n).sqrt() + 7.0 * (high - low) * l / (3.0 * (n - 1.0))
}

/// True if whatever noise the range of the draws may hide moves their mean by no more than is tolerated.
pub(super) fn tolerated(sums: &PowerSums, claim: &MeanClaim) -> bool {
    let width = |range| bernstein_width(sums.variance(), sums.n as f64, range, REPORTING_LEVEL);
    let hides = |range| within(sums, range) && bias(sums, claim).abs() + width(range) <= claim.slack;
    claim.range.is_some_and(hides)
}

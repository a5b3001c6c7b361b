//! The two terms of Loader's saddle-point form of the binomial, Poisson and gamma densities (C. Loader, "Fast and
//! accurate computation of binomial probabilities", 2000): what is left of a factorial after Stirling's formula, and
//! the deviance. Both keep full relative accuracy where differences of log-gammas cancel.

/// ln sqrt(2 pi)
pub(super) const LN_SQRT_TAU: f64 = 0.918_938_533_204_672_7;

/// The error of Stirling's formula, for k > 0.
///
/// ```text
/// ln Gamma(k + 1) - (k + 1/2) ln k + k - ln sqrt(2 pi)
/// ```
pub(super) fn stirling_error(k: f64) -> f64 {
    if k < 16.0 {
        return libm::lgamma(k + 1.0) - (k + 0.5) * libm::log(k) + k - LN_SQRT_TAU;
    }
    let r = 1.0 / (k * k);
    let tail = 1.0 / 1260.0 - r * (1.0 / 1680.0 - r * (1.0 / 1188.0 - r * (691.0 / 360_360.0)));
    (1.0 / 12.0 - r * (1.0 / 360.0 - r * tail)) / k
}

/// The deviance of a count k from its mean, given their difference exactly (k and mean may agree to all digits).
///
/// ```text
/// k ln(k / mean) - (k - mean),   by 2 atanh(v) = ln(k / mean), v = (k - mean) / (k + mean), if v is small
/// ```
pub(super) fn deviance(k: f64, mean: f64, excess: f64) -> f64 {
    let v = excess / (k + mean);
    if v.abs() >= 0.2 {
        return k * libm::log(k / mean) - excess;
    }
    let odd_powers = (3..30).step_by(2).rev().fold(0.0, |sum, odd| sum * v * v + 1.0 / f64::from(odd));
    excess * v + 2.0 * k * odd_powers * v * v * v
}

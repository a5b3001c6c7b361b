//! The incomplete gamma function ratios.

use super::fraction::{MAX_TERMS, continued_fraction};
use super::saddle_point::{LN_SQRT_TAU, deviance, stirling_error};
use statrs::function::gamma::{checked_gamma_lr, checked_gamma_ur};

/// statrs 0.19.1 is good to 1e-11 up to here (chi-square tails to 1e-300), off by 2e-10 at a = 6e4 and 1.3e-8 at
/// a = 5e6: its prefactor exp(a ln x - x - ln Gamma(a)) cancels.
const STATRS_LIMIT: f64 = 5000.0;

/// P(a, x) and Q(a, x) for finite a > 0 and x > 0, each with full relative accuracy.
pub(super) fn gamma_tails(a: f64, x: f64) -> (f64, f64) {
    if a <= STATRS_LIMIT {
        let tail = |value: Result<f64, _>| value.unwrap_or(f64::NAN);
        return (tail(checked_gamma_lr(a, x)), tail(checked_gamma_ur(a, x)));
    }
    if x < a {
        let lower = density(a, x) * series(a, x);
        (lower, 1.0 - lower)
    } else {
        let upper = density(a, x) * a / upper_fraction(a, x);
        (1.0 - upper, upper)
    }
}

/// x^a e^-x / Gamma(a + 1), by Loader's saddle point.
fn density(a: f64, x: f64) -> f64 {
    libm::exp(-deviance(a, x, a - x) - stirling_error(a) - LN_SQRT_TAU) / a.sqrt()
}

/// 1 + x/(a+1) + x^2/((a+1)(a+2)) + ..: P over the density.
fn series(a: f64, x: f64) -> f64 {
    let (mut sum, mut term) = (1.0, 1.0);
    for m in 1..MAX_TERMS {
        term *= x / (a + f64::from(m));
        sum += term;
        if term < sum * f64::EPSILON / 16.0 {
            return sum;
        }
    }
    f64::NAN
}

/// Legendre's fraction for x^a e^-x / Gamma(a, x).
fn upper_fraction(a: f64, x: f64) -> f64 {
    let excess = x - a;
    continued_fraction(excess + 1.0, |m| (m * (a - m), excess + 2.0 * m + 1.0))
}

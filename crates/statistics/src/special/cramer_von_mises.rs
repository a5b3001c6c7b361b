use super::alternating;
use std::f64::consts::PI;

mod first_order;

/// Below it the tail of the limit law is 1 to the last digit.
const LEAST: f64 = 1.4e-3;

/// Beyond it the tail is below 1e-320.
const MOST: f64 = 150.0;

/// The correction takes away some 3.3 z^2 / n of the tail: beyond half of it, or where it is no longer told from rounding, the
/// ratio to the limit law is held.
fn border(n: f64) -> f64 {
    let half = (0.15 * n).sqrt();
    if half < 2.0 { half } else { 2.0 }
}

/// Upper tail of the Cramer-von Mises statistic of many draws from a law that is fully given.
///
/// ```text
/// W^2 = m int (F_m - F)^2 dF  ->  sum_j Z_j^2 / (j pi)^2
/// P(W^2 >= z) = 1/pi sum_k (-1)^(k+1) int_(2k-1)^(2k) exp(-z mu/2) / (mu sqrt|D|) dmu,   mu = (pi x)^2,   D = sin(pi x) / (pi x)
/// ```
///
/// Domain: any z; NaN gives NaN. Accuracy: 1e-12 down to 1e-300, as a limit. Cost: 1 to 40 times max(40, 25 sqrt z)
/// evaluations. Source: Smirnov (1937).
#[must_use]
pub fn cramer_von_mises_limit_sf(z: f64) -> f64 {
    if z.is_nan() {
        f64::NAN
    } else if z < LEAST {
        1.0
    } else if z > MOST {
        0.0
    } else {
        let nodes = 40 + (25.0 * z.sqrt()) as usize;
        alternating::sum(nodes, |x| libm::exp(-0.5 * z * PI * PI * x * x) * 2.0 * (PI / x).sqrt())
    }
}

/// Upper tail of the Cramer-von Mises statistic of `n` draws: the limit law and its first correction.
///
/// ```text
/// P(W^2 >= z) = S(z) - (V(z) / 12 + psi(z)) / n + O(1/n^2),   V = 1 - S,   0 beyond n/3, 1 up to 1/(12 n)
/// ```
///
/// Domain: n >= 1, else NaN; any z. Accuracy: an approximation, off by O(1/n^2); exact for n = 1. Beyond
/// z = min(2, sqrt(0.15 n)) the ratio to the limit law stays what it is there, which is too large a p-value: the true ratio goes
/// on falling.
/// Source: Csorgo and Faraway (1996), equation 1.10.
#[must_use]
pub fn cramer_von_mises_sf(n: u64, z: f64) -> f64 {
    let draws = n as f64;
    if n == 0 || z.is_nan() {
        f64::NAN
    } else if z * 12.0 * draws <= 1.0 {
        1.0
    } else if z * 3.0 >= draws {
        0.0
    } else if n == 1 {
        1.0 - 2.0 * (z - 1.0 / 12.0).sqrt()
    } else if z > border(draws) {
        let border = border(draws);
        corrected(draws, border) / cramer_von_mises_limit_sf(border) * cramer_von_mises_limit_sf(z)
    } else {
        corrected(draws, z)
    }
}

/// The first two terms, kept within what a probability may be.
fn corrected(n: f64, z: f64) -> f64 {
    let tail = cramer_von_mises_limit_sf(z);
    (tail - ((1.0 - tail) / 12.0 + first_order::psi(z)) / n).clamp(0.0, 1.0)
}

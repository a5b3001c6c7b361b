//! The incomplete beta function ratio in the tail where it is small.

use super::fraction::continued_fraction;

/// The continued fraction F of the incomplete beta function ratio (DiDonato and Morris, "Algorithm 708", 1992, BFRAC).
///
/// ```text
/// I_x(a, b) = x^a y^b / (B(a, b) F),   y = 1 - x,   lambda = a y - b x
/// ```
///
/// Converges fast for lambda > 0. `y` and `lambda` are asked for because both cancel when made from x.
pub(super) fn beta_fraction(a: f64, b: f64, (x, y): (f64, f64), lambda: f64) -> f64 {
    continued_fraction(a * (lambda + 1.0) / (a + 1.0), |m| {
        let s = a + 2.0 * m;
        let w = m * (b - m) * x / (s - 1.0);
        let numerator = w * x * (a + m - 1.0) * (a + b + m - 1.0) / (s - 1.0);
        (numerator, m + w + (a + m) * (lambda + 1.0 + m * (1.0 + y)) / (s + 1.0))
    })
}

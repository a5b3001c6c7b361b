//! Continued fractions.

/// A bound on every loop, for arguments outside the domain: 2e5 terms do at a mean of 1e9, and 6e6 at 1e12.
pub(super) const MAX_TERMS: u32 = 10_000_000;

/// b0 + a1 / (b1 + a2 / (b2 + ..)) by the modified Lentz rule (Thompson and Barnett 1986); NaN if it does not converge.
///
/// `term(m)` gives (a_m, b_m).
pub(super) fn continued_fraction(b0: f64, term: impl Fn(f64) -> (f64, f64)) -> f64 {
    let (mut value, mut c, mut d) = (b0, b0, 0.0);
    for m in 1..MAX_TERMS {
        let (a, b) = term(f64::from(m));
        d = 1.0 / (b + a * d);
        c = b + a / c;
        value *= c * d;
        if (c * d - 1.0).abs() < f64::EPSILON {
            return value;
        }
        if value.is_nan() {
            break;
        }
    }
    f64::NAN
}

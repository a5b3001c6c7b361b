use std::f64::consts::PI;

/// Upper tail of Kuiper's statistic of `n` draws from a continuous law.
///
/// ```text
/// V = D+ + D-,   P(V >= v) ~ Q((sqrt n + 0.155 + 0.24 / sqrt n) v)
/// Q(x) = 2 sum_(j >= 1) (4 j^2 x^2 - 1) exp(-2 j^2 x^2)
///      = 1 - sqrt(2 pi) sum_(k >= 1) (pi k)^2 / x^3 exp(-(pi k)^2 / (2 x^2))
/// ```
///
/// Domain: n >= 1, else NaN; any v; 1 up to v = 1/n, which V always reaches, and 0 beyond v = 1. Accuracy: Q to 1e-12 down to
/// 1e-300; Stephens' correction to some 1e-3 of p for n >= 100 where p > 1e-3, farther out of the limit law's own order.
/// Source: Kuiper (1960), Stephens (1970).
#[must_use]
pub fn kuiper_sf(n: u64, v: f64) -> f64 {
    let root = (n as f64).sqrt();
    if n == 0 || v.is_nan() {
        f64::NAN
    } else if v * n as f64 <= 1.0 {
        1.0
    } else if v > 1.0 {
        0.0
    } else {
        limit_sf((root + 0.155 + 0.24 / root) * v)
    }
}

/// Q(x) by the series that converges at once.
fn limit_sf(x: f64) -> f64 {
    let sum = |term: &dyn Fn(f64) -> f64| {
        let terms = (1..30).map(|j| term(f64::from(j * j)));
        terms.sum::<f64>()
    };
    if x < 1.0 {
        let (a, scale) = (PI * PI / (x * x), (2.0 * PI).sqrt() / x);
        1.0 - scale * sum(&|k2| k2 * a * libm::exp(-0.5 * k2 * a))
    } else {
        2.0 * sum(&|j2| (4.0 * j2 * x * x - 1.0) * libm::exp(-2.0 * j2 * x * x))
    }
}

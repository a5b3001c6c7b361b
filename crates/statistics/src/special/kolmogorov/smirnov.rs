//! The exact one-sided tail (Smirnov 1944; Birnbaum and Tingey 1951).

use crate::special::binomial::Trials;

/// Above this n the sum over j, smooth and vanishing at both ends in the tail, is taken by the trapezoid rule with as
/// many nodes. At n d^2 > 4.2, where 128 already give 22 digits, this is no approximation.
const NODES: f64 = 1024.0;

/// P(sup F_n(x) - F(x) >= d) for 0 < d < 1, with n d^2 > 4.2 if n is above `NODES`.
///
/// ```text
/// d sum_j C(n, j) x^(j-1) (1 - x)^(n-j),   x = d + j / n,   0 <= j <= n (1 - d)
/// ```
///
/// Every term is positive, and is a binomial mass n d away from its mean.
pub(super) fn one_sided_sf(n: f64, d: f64) -> f64 {
    let range = n * (1.0 - d);
    let step = if n > NODES { range / NODES } else { 1.0 };
    let (mut sum, mut j) = (0.0, 0.0);
    while j <= range {
        sum += term(n, d, j);
        j += step;
    }
    sum * step
}

fn term(n: f64, d: f64, j: f64) -> f64 {
    let x = d + j / n;
    let q = (n - j) / n - d;
    if q <= 0.0 {
        return 0.0;
    }
    libm::exp(Trials { n, p: x, q }.ln_mass_off(j, -n * d)) * d / x
}

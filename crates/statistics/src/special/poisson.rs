use super::doubled::doubled;
use super::incomplete_gamma::gamma_tails;

/// P(X >= k) for a Poisson count X.
///
/// ```text
/// P(X >= k) = P(k, mean), the lower incomplete gamma ratio
/// ```
///
/// Domain: 0 <= mean < infinity, else NaN; k exact below 2^53. Accuracy and source: as [`super::chi_square_sf`].
#[must_use]
pub fn poisson_sf(mean: f64, k: u64) -> f64 {
    if !(0.0..f64::INFINITY).contains(&mean) {
        f64::NAN
    } else if k == 0 {
        1.0
    } else if mean <= 0.0 {
        0.0
    } else {
        gamma_tails(k as f64, mean).0
    }
}

/// P(X <= k) for a Poisson count X.
///
/// ```text
/// P(X <= k) = Q(k + 1, mean), the upper incomplete gamma ratio
/// ```
///
/// Domain, accuracy and source: as [`poisson_sf`].
#[must_use]
pub fn poisson_cdf(mean: f64, k: u64) -> f64 {
    if !(0.0..f64::INFINITY).contains(&mean) {
        f64::NAN
    } else if mean <= 0.0 {
        1.0
    } else {
        gamma_tails(k as f64 + 1.0, mean).1
    }
}

/// Two-sided p-value of a Poisson count: the smaller tail doubled, at most 1.
///
/// ```text
/// min(1, 2 min(P(X <= k), P(X >= k)))
/// ```
///
/// Domain, accuracy and source: as [`poisson_sf`].
#[must_use]
pub fn poisson_two_sided(mean: f64, k: u64) -> f64 {
    doubled(poisson_cdf(mean, k), poisson_sf(mean, k))
}

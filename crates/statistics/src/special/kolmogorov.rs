//! The law of the Kolmogorov-Smirnov distance.

mod durbin;
mod pelz_good;
mod smirnov;

/// Beyond n d^2 = 4.2 both one-sided distances pass d together so seldom (e^(-6 n d^2) < 1.2e-11 of the whole) that the
/// two-sided tail is twice the one-sided.
const ONE_SIDED: f64 = 4.2;

/// Largest n whose body is computed exactly.
const EXACT: u64 = 2000;

/// Upper tail of the two-sided Kolmogorov-Smirnov distance of n draws from a continuous law.
///
/// ```text
/// P(D_n >= d),   D_n = sup |F_n(x) - F(x)|
/// ```
///
/// Domain: n >= 1, else NaN; any d. Accuracy: 1e-10 for n <= 2000; above, 1e-10 where n d^2 > 4.2 (p < 4.5e-4) and
/// 2e-7 elsewhere. Source: Durbin (1973), Pelz and Good (1976), Birnbaum and Tingey (1951), joined much as by Simard and
/// L'Ecuyer (2011). statrs 0.19.1 gives 1.0 for 7e-57 at n = 1030 and NaN from n = 2000; its limit law is off by a
/// factor of 3 there.
#[doc(alias = "kolmogorov")]
#[must_use]
pub fn ks_two_sided(n: u64, d: f64) -> f64 {
    let draws = n as f64;
    if n == 0 || d.is_nan() {
        f64::NAN
    } else if draws * d <= 0.5 {
        1.0
    } else if d >= 1.0 {
        0.0
    } else if d >= 0.5 || draws * d * d > ONE_SIDED {
        2.0 * smirnov::one_sided_sf(draws, d)
    } else if n <= EXACT {
        1.0 - durbin::cdf(n, d)
    } else {
        1.0 - pelz_good::cdf(draws, d)
    }
}

/// Upper tail of the one-sided Kolmogorov-Smirnov distance of n draws from a continuous law.
///
/// ```text
/// P(D_n^+ >= d),   D_n^+ = sup F_n(x) - F(x)
/// ```
///
/// Domain: n >= 1, else NaN; any d. Accuracy: 1e-10 for n <= 1000 or n d^2 > 4.2, 1e-3 elsewhere. Source: Birnbaum and
/// Tingey (1951); exp(-2 n (d + 1 / (6 n))^2) elsewhere (Smirnov 1944, with its first correction).
#[must_use]
pub fn ks_one_sided(n: u64, d: f64) -> f64 {
    let draws = n as f64;
    if n == 0 || d.is_nan() {
        f64::NAN
    } else if d <= 0.0 {
        1.0
    } else if d >= 1.0 {
        0.0
    } else if n <= 1000 || draws * d * d > ONE_SIDED {
        smirnov::one_sided_sf(draws, d)
    } else {
        let shifted = d + 1.0 / (6.0 * draws);
        libm::exp(-2.0 * draws * shifted * shifted)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_one_sided_tail_joins_and_one_draw_is_uniform() {
        assert!((ks_one_sided(1, 0.3) - 0.7).abs() < 1e-12);
        for d in [0.005, 0.01, 0.03, 0.05] {
            let (exact, limit) = (ks_one_sided(1000, d), ks_one_sided(1001, d));
            assert!((limit / exact - 1.0).abs() < 5e-3, "{d}: {exact} {limit}");
        }
        let (tail, two) = (ks_one_sided(100_000, 0.01), ks_two_sided(100_000, 0.01));
        assert!((2.0 * tail / two - 1.0).abs() < 1e-9);
        assert!(ks_one_sided(0, 0.1).is_nan() && ks_one_sided(5, f64::NAN).is_nan());
    }
}

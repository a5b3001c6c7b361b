use super::binomial::Trials;
use super::doubled::doubled;

/// Two-sided p-value of Fisher's exact test: X of `hits` hits fall among the first `n` of `total` draws; the smaller tail doubled,
/// at most 1.
///
/// ```text
/// P(X = x) = C(n, x) C(total - n, hits - x) / C(total, hits) = b(x; n, p) b(hits - x; total - n, p) / b(hits; total, p)
/// ```
///
/// Domain: k <= n <= total, k <= hits <= total, and no more misses than there are, else NaN. Accuracy: 1e-10 to total = 1e9.
/// Source: Loader (2000) for the mass; tails are summed from k outwards.
#[must_use]
pub fn hypergeometric_two_sided(k: u64, n: u64, hits: u64, total: u64) -> f64 {
    if k > n || n > total || k > hits || hits > total || hits - k > total - n {
        return f64::NAN;
    }
    if hits == 0 || hits == total {
        return 1.0;
    }
    let (k, n, hits, total) = (k as f64, n as f64, hits as f64, total as f64);
    let at_least = upper(k, n, hits, total);
    let at_most = upper(hits - k, total - n, hits, total); // those that fall among the others
    doubled(at_most, at_least)
}

/// P(X >= k).
fn upper(k: f64, n: f64, hits: f64, total: f64) -> f64 {
    let p = hits / total;
    let of = |trials: f64, count: f64| if trials > 0.0 { Trials::new(trials, p).ln_mass(count) } else { 0.0 };
    let mut term = libm::exp(of(n, k) + of(total - n, hits - k) - of(total, hits));
    let (mut x, mut sum) = (k, 0.0);
    while term > 1e-17 * sum {
        sum += term;
        term *= (n - x) * (hits - x) / ((x + 1.0) * (total - n - hits + x + 1.0));
        x += 1.0;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By whole numbers: C(n, k).
    fn choose(n: u64, k: u64) -> f64 {
        (0..k).fold(1.0, |c, i| c * (n - i) as f64 / (i + 1) as f64)
    }

    #[test]
    fn it_is_the_sum_of_the_smaller_tail() {
        let (n, hits, total) = (12, 9, 30);
        let mass = |x: u64| choose(n, x) * choose(total - n, hits - x) / choose(total, hits);
        for k in 0..=9 {
            let (low, high): (f64, f64) = ((0..=k).map(mass).sum(), (k..=9).map(mass).sum());
            let expected = 2.0 * if low < high { low } else { high };
            let expected = if expected > 1.0 { 1.0 } else { expected };
            assert!((hypergeometric_two_sided(k, n, hits, total) / expected - 1.0).abs() < 1e-12, "{k}");
        }
    }

    #[test]
    fn ends_and_impossible_counts() {
        assert!(hypergeometric_two_sided(0, 5, 0, 10) >= 1.0);
        assert!(hypergeometric_two_sided(5, 5, 10, 10) >= 1.0);
        assert!(hypergeometric_two_sided(6, 5, 6, 10).is_nan());
        assert!(hypergeometric_two_sided(0, 5, 6, 10).is_nan());
        assert!(hypergeometric_two_sided(0, 1_000_000, 1000, 2_000_000) < 1e-300);
        assert!((hypergeometric_two_sided(500_000, 1_000_000, 1_000_000, 2_000_000) - 1.0).abs() < 1e-3);
    }
}

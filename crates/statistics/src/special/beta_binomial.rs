use super::binomial::Trials;

/// ln of a beta-binomial mixture of likelihoods over the likelihood of p, after k successes in n trials.
///
/// ```text
/// ln [ B(a + k, b + n - k) / (B(a, b) p^k (1 - p)^(n - k)) ]
/// ```
///
/// Domain: a, b > 0, 0 < p < 1, k <= n; p = 0 gives infinity if k > 0, else 0, which is more than the value; p = 1
/// likewise. Accuracy: 1e-9 absolute to n = 1e9: both beta functions are written as binomial masses at p in the form of
/// Loader (2000), in which the powers of p cancel.
#[must_use]
pub fn ln_beta_binomial_ratio((a, b): (f64, f64), n: u64, k: u64, p: f64) -> f64 {
    if !(a > 0.0 && b > 0.0 && (0.0..=1.0).contains(&p) && k <= n) {
        return f64::NAN;
    }
    let (hits, misses) = (k as f64, (n - k) as f64);
    if p <= 0.0 || p >= 1.0 {
        let possible = if p <= 0.0 { k == 0 } else { k == n };
        return if possible { 0.0 } else { f64::INFINITY };
    }
    let (prior, all) = (a + b, a + b + n as f64);
    let mass = |total: f64, part: f64| Trials::new(total, p).ln_mass(part);
    libm::log(all / (a + hits) * (a / prior) * (b / (b + misses))) - mass(all, a + hits) + mass(prior, a)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By log-gammas: exact enough where n is small.
    fn by_gammas((a, b): (f64, f64), n: u64, k: u64, p: f64) -> f64 {
        let ln_beta = |a: f64, b: f64| libm::lgamma(a) + libm::lgamma(b) - libm::lgamma(a + b);
        let (hits, misses) = (k as f64, (n - k) as f64);
        ln_beta(a + hits, b + misses) - ln_beta(a, b) - hits * libm::log(p) - misses * libm::log1p(-p)
    }

    #[test]
    fn it_is_the_ratio_of_beta_functions() {
        for prior in [(0.5, 0.5), (3.0, 17.0), (400.5, 2600.5)] {
            for (n, k) in [(0, 0), (1, 0), (1, 1), (100, 13), (10_000, 1300), (10_000, 10_000)] {
                for p in [1e-6, 0.13, 0.5, 0.999] {
                    let (x, y) = (ln_beta_binomial_ratio(prior, n, k, p), by_gammas(prior, n, k, p));
                    assert!((x - y).abs() <= 1e-9 * (1.0 + y.abs()), "{prior:?} {n} {k} {p}: {x} {y}");
                }
            }
        }
    }

    #[test]
    fn it_keeps_its_digits_at_many_trials() {
        let (n, p) = (1_000_000_000, 0.125);
        let at = |k| ln_beta_binomial_ratio((125.5, 875.5), n, k, p);
        let (mean, sd2) = (125_000_000, 1e9 * p * (1.0 - p));
        for d in [0u32, 10_000, 60_000] {
            let expected = f64::from(d) * f64::from(d) / (2.0 * sd2) - 0.5 * libm::log(1e9 / 1001.0);
            assert!(
                (at(mean + u64::from(d)) - expected).abs() < 0.02,
                "{d}: {} {expected}",
                at(mean + u64::from(d))
            );
        }
        assert!(at(0) > 1e7 && at(n) > 1e8);
    }

    #[test]
    fn what_cannot_happen_is_infinitely_unlikely() {
        assert!(ln_beta_binomial_ratio((1.0, 1.0), 9, 1, 0.0) >= f64::INFINITY);
        assert!(ln_beta_binomial_ratio((1.0, 1.0), 9, 9, 1.0).abs() <= 0.0);
        assert!(ln_beta_binomial_ratio((1.0, 1.0), 9, 1, f64::NAN).is_nan());
    }
}

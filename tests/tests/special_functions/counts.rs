//! Counts of 1e9 trials, at the ends and within time.

use crate::distance;
use freepath_statistics::special::*;
use std::time::{Duration, Instant};

const N: u64 = 1_000_000_000;

/// Every k that has ever made an incomplete beta function fail, under rare, even and frequent success.
fn grid() -> impl Iterator<Item = (u64, f64)> {
    let counts = [0, 1, 2, 1000, N / 2 - 1, N / 2, N / 2 + 1, N - 1000, N - 2, N - 1, N];
    let shares = [1e-300, 1e-18, 1e-9, 2e-9, 1e-4, 0.5, 1.0 - 1e-4, 1.0 - 1e-9, 1.0 - 1e-16];
    counts.into_iter().flat_map(move |k| shares.into_iter().map(move |p| (k, p)))
}

#[test]
fn the_binomial_holds_at_1e9_and_does_not_hang() {
    let start = Instant::now();
    for (k, p) in grid() {
        let (lower, upper) = (binomial_cdf(N, p, k), binomial_sf(N, p, k));
        let at = format!("k {k} p {p}: {lower:e} and {upper:e}");
        assert!((0.0..=1.0 + 1e-12).contains(&lower) && (0.0..=1.0 + 1e-12).contains(&upper), "{at}");
        assert!(lower + upper >= 1.0 - 1e-12, "{at}");
        if k < N {
            assert!((lower + binomial_sf(N, p, k + 1) - 1.0).abs() < 1e-12, "{at}");
        }
    }
    // Closed forms: (1 - p)^n, p^n, and one more than all but one.
    let none = libm::exp(N as f64 * libm::log1p(-2e-9));
    assert!(distance(binomial_cdf(N, 2e-9, 0), none) < 1e-12);
    assert!(distance(binomial_sf(N, 2e-9, 1), 1.0 - none) < 1e-12);
    let p = 1.0 - libm::ldexp(1.0, -29); // a double, and so is what is left
    let all = libm::exp(N as f64 * libm::log1p(-libm::ldexp(1.0, -29)));
    assert!(distance(binomial_sf(N, p, N), all) < 1e-12);
    assert!(distance(binomial_cdf(N, p, N - 1), 1.0 - all) < 1e-12);
    assert!(start.elapsed() < Duration::from_secs(1), "{:?}", start.elapsed());
}

#[test]
fn clopper_pearson_holds_at_1e9_and_does_not_hang() {
    let start = Instant::now();
    for k in [0, 1, 2, N / 2, N - 2, N - 1, N] {
        for alpha in [0.5, 0.05, 1e-9, 1e-100, 1e-300] {
            let (lower, upper) = clopper_pearson(N, k, alpha);
            let share = k as f64 / N as f64;
            let at = format!("k {k} alpha {alpha}: {lower:e} to {upper:e}");
            assert!(lower >= 0.0 && lower <= share && share <= upper && upper <= 1.0, "{at}");
        }
    }
    // Closed forms at the ends: 1 - (alpha / 2)^(1/n).
    let end = |alpha: f64| -libm::expm1(libm::log(0.5 * alpha) / N as f64);
    for alpha in [0.05, 1e-9, 1e-300] {
        assert!(distance(clopper_pearson(N, 0, alpha).1, end(alpha)) < 1e-12);
        assert!(distance(1.0 - clopper_pearson(N, N, alpha).0, end(alpha)) < 1e-6);
    }
    assert!(start.elapsed() < Duration::from_secs(1), "{:?}", start.elapsed());
}

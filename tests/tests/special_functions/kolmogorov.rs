//! The Kolmogorov-Smirnov tail: its ends, its fall, and the borders between its methods.

use crate::{assert_same, distance};
use freepath_statistics::special::*;

#[test]
fn kolmogorov_smirnov_has_its_ends() {
    for n in [1, 2, 10, 2000, 2001, 100_000, 1_000_000_000] {
        let floor = 0.5 / n as f64;
        assert_same(&[
            (ks_two_sided(n, -0.1), 1.0),
            (ks_two_sided(n, 0.0), 1.0),
            (ks_two_sided(n, floor), 1.0),
            (ks_two_sided(n, 1.0), 0.0),
            (ks_two_sided(n, 1.5), 0.0),
            (ks_two_sided(n, f64::INFINITY), 0.0),
        ]);
    }
    // One draw: D = max(u, 1 - u).
    assert!(distance(ks_two_sided(1, 0.7), 0.6) < 1e-15);
    // Every draw in its own 1 / n, none further than d - 1 / (2 n) from its centre: 1 - n! (2 d - 1 / n)^n.
    assert!(distance(ks_two_sided(3, 0.3), 1.0 - 6.0 * (0.6_f64 - 1.0 / 3.0).powi(3)) < 1e-14);
}

#[test]
fn kolmogorov_smirnov_falls_with_distance() {
    for n in [1, 2, 3, 7, 16, 17, 150, 1000, 1025, 2000, 2001, 50_000, 10_000_000, 1_000_000_000] {
        let mut last = 1.0;
        for step in 0..1000 {
            // To d = 1 or z = 28, where p is below 1e-600.
            let d = (f64::from(step) * 0.028 / (n as f64).sqrt()).clamp(0.0, 1.0);
            let p = ks_two_sided(n, d);
            assert!((0.0..=1.0).contains(&p) && p <= last * (1.0 + 1e-10), "n {n} d {d}: {p:e} after {last:e}");
            last = p;
        }
        assert_same(&[(last, 0.0)]);
    }
}

#[test]
fn kolmogorov_smirnov_is_continuous_across_its_methods() {
    for n in [17, 50, 300, 1024, 1025, 2000, 2001, 100_000, 1_000_000_000] {
        let border = (4.2 / n as f64).sqrt();
        let (below, above) = (ks_two_sided(n, border * (1.0 - 1e-13)), ks_two_sided(n, border * (1.0 + 1e-13)));
        let tolerance = if n <= 2000 { 1e-10 } else { 1e-6 };
        assert!(distance(below, above) < tolerance, "n {n}: {below:e} and {above:e}");
    }
    for n in 2..17 {
        let (below, above) = (ks_two_sided(n, 0.5_f64.next_down()), ks_two_sided(n, 0.5));
        assert!(distance(below, above) < 1e-12, "n {n}: {below:e} and {above:e}");
    }
    for z in [0.4, 0.6, 0.83, 1.2, 1.63, 2.0] {
        let [a, b, c] = [1999_u64, 2000, 2001].map(|n| ks_two_sided(n, z / (n as f64).sqrt()));
        // By extrapolation from the exact n: what is left is the error of the approximation.
        assert!(distance(2.0 * b - a, c) < 1e-6, "z {z}: {a:e}, {b:e}, {c:e}");
    }
}

//! The tails of Anderson-Darling, Cramer-von Mises and Kuiper: ends, fall, and reach.

use crate::{assert_same, distance};
use freepath_statistics::special::*;

const COUNTS: [u64; 10] = [1, 2, 3, 7, 10, 100, 1000, 100_000, 10_000_000, 1_000_000_000];

#[test]
fn nan_and_no_draws_give_nan() {
    let nan = f64::NAN;
    let values = [
        anderson_darling_sf(nan),
        cramer_von_mises_limit_sf(nan),
        cramer_von_mises_sf(10, nan),
        cramer_von_mises_sf(0, 0.3),
        kuiper_sf(10, nan),
        kuiper_sf(0, 0.3),
    ];
    assert!(values.iter().all(|value| value.is_nan()), "{values:?}");
}

#[test]
fn the_ends_are_exact() {
    let infinity = f64::INFINITY;
    assert_same(&[
        (anderson_darling_sf(0.0), 1.0),
        (anderson_darling_sf(-1.0), 1.0),
        (anderson_darling_sf(infinity), 0.0),
        (cramer_von_mises_limit_sf(0.0), 1.0),
        (cramer_von_mises_limit_sf(infinity), 0.0),
    ]);
    for n in COUNTS {
        let (least, share) = (1.0 / (12.0 * n as f64), 1.0 / n as f64);
        assert_same(&[
            (cramer_von_mises_sf(n, 0.99 * least), 1.0),
            (cramer_von_mises_sf(n, n as f64 / 3.0), 0.0),
            (cramer_von_mises_sf(n, infinity), 0.0),
            (kuiper_sf(n, 0.0), 1.0),
            (kuiper_sf(n, share), 1.0),
            (kuiper_sf(n, 1.0_f64.next_up()), 0.0),
        ]);
    }
    // One draw: W^2 = 1/12 + (u - 1/2)^2.
    assert!(distance(cramer_von_mises_sf(1, 1.0 / 12.0 + 0.09), 0.4) < 1e-14);
}

/// A tail falls from 1 to 0 and is never NaN.
fn falls(name: &str, tail: impl Fn(f64) -> f64, step: f64) {
    let mut last = 1.0;
    for i in 0..1500 {
        let z = step * f64::from(i);
        let p = tail(z);
        assert!((0.0..=1.0).contains(&p) && p <= last * (1.0 + 1e-10), "{name} at {z}: {p:e} after {last:e}");
        last = p;
    }
    assert_same(&[(last, 0.0)]);
}

#[test]
fn tails_fall_with_the_statistic() {
    falls("Anderson-Darling", anderson_darling_sf, 0.5);
    falls("Anderson-Darling near 0", |z| if z < 14.9 { anderson_darling_sf(z) } else { 0.0 }, 0.01);
    falls("Cramer-von Mises", cramer_von_mises_limit_sf, 0.11);
    for n in COUNTS {
        let root = (n as f64).sqrt();
        falls(&format!("Cramer-von Mises of {n}"), |z| cramer_von_mises_sf(n, z), 0.11);
        falls(&format!("Cramer-von Mises of {n} near 0"), |z| cramer_von_mises_sf(n, z * z * 170.0), 1e-3);
        falls(&format!("Kuiper of {n}"), |x| kuiper_sf(n, x / root), 0.02);
    }
}

#[test]
fn tails_reach_1e_300() {
    // Leading terms: sqrt(3 / (pi z)) e^-z and 2 / (pi^1.5 sqrt z) e^(-pi^2 z / 2), good to 1 / z.
    let pi = std::f64::consts::PI;
    let anderson = (3.0 / (pi * 690.0)).sqrt() * libm::exp(-690.0);
    assert!(distance(anderson_darling_sf(690.0), anderson) < 2.0 / 690.0);
    let cramer = 2.0 / (libm::pow(pi, 1.5) * 139.0_f64.sqrt()) * libm::exp(-0.5 * pi * pi * 139.0);
    assert!(distance(cramer_von_mises_limit_sf(139.0), cramer) < 2.0 / 139.0);
    let kuiper = 2.0 * (4.0 * 18.5 * 18.5 - 1.0) * libm::exp(-2.0 * 18.5 * 18.5);
    assert!(kuiper < 1e-290 && distance(kuiper_of_many(18.5), kuiper) < 1e-5);
}

/// The limit law: of so many draws that the correction vanishes.
fn kuiper_of_many(x: f64) -> f64 {
    kuiper_sf(1 << 52, x / f64::from(1 << 26))
}

#[test]
fn kuiper_has_its_table() {
    // Stephens (1970), table 1: upper percentage points of the modified V, to three decimals.
    for (x, p) in [(1.62, 0.1), (1.747, 0.05), (1.862, 0.025), (2.001, 0.01)] {
        let (below, above) = (kuiper_of_many(x + 5e-4), kuiper_of_many(x - 5e-4));
        assert!(below <= p && p <= above, "{x}: {below} to {above}");
    }
    let (below, above) = (kuiper_of_many(1.0 - 1e-8), kuiper_of_many(1.0 + 1e-8));
    assert!(distance(below, above) < 1e-6, "{below} and {above}");
}

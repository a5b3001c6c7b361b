//! Moments of ray marching through narrow bumps.

use crate::zoo::{BASE, Bump, LENGTH, PEAK, bumps, close, estimator};

const STEPS: u32 = 16;
const H: f64 = LENGTH / STEPS as f64;

/// int_a^b exp(-s g) by its series, s at most 3.
fn exponential(bump: Bump, s: f64, a: f64, b: f64) -> f64 {
    let (mut sum, mut term) = (0.0, 1.0);
    for power in 0..40 {
        sum += term * bump.area(power, a, b);
        term *= -s / f64::from(power + 1);
    }
    sum
}

fn step(j: u32) -> (f64, f64) {
    (H * f64::from(j), H * f64::from(j + 1))
}

#[test]
fn a_stratified_march_has_the_moments_of_the_closed_form() {
    let march = estimator(r#"{"ray_marching": {"rule": "stratified", "steps": 16}}"#);
    for bump in bumps() {
        let claims = march.claims(&bump.medium());
        assert!(claims.moments_error < 1e-10, "{bump:?}: {:e}", claims.moments_error);
        for (k, found) in (1..).zip(claims.moments.expect("known")) {
            let mean = |j| {
                let (a, b) = step(j);
                libm::exp(-k as f64 * H * BASE) * exponential(bump, k as f64 * H * PEAK, a, b) / H
            };
            close(found, (0..STEPS).map(mean).product(), 1e-11, &(bump, k));
        }
    }
}

#[test]
fn a_comb_that_meets_a_bump_once_has_the_moments_of_the_closed_form() {
    let march = estimator(r#"{"ray_marching": {"rule": "comb", "steps": 16}}"#);
    let within = |bump: &Bump| {
        let place = bump.center / H;
        let near = (place - place.round()).abs() * H;
        near > 9.0 * bump.width
    };
    let met: Vec<Bump> = bumps().into_iter().filter(within).collect();
    assert!(met.len() > 80, "{}", met.len());
    for bump in met {
        let claims = march.claims(&bump.medium());
        assert!(claims.moments_error < 1e-10, "{bump:?}: {:e}", claims.moments_error);
        let (a, b) = step((bump.center / H) as u32);
        for (k, found) in (1..).zip(claims.moments.expect("known")) {
            let k_h = k as f64 * H;
            let due = libm::exp(-k_h * BASE * f64::from(STEPS)) * exponential(bump, k_h * PEAK, a, b) / H;
            close(found, due, 1e-11, &(bump, k));
        }
    }
}

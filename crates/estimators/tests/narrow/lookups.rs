//! Expected look-ups of analog walks.

use crate::zoo::{BASE, LENGTH, close};
use freepath_estimators::Medium;
use freepath_estimators::claims::FreePathClaims;
use freepath_estimators::free_path::AnyFreePath;
use freepath_estimators::medium::{BoxSpike, Constant, Exponential, Gaussian};

fn check(medium: &dyn Medium, due: f64, what: &dyn std::fmt::Debug) {
    let tracking: AnyFreePath = serde_json::from_str(r#"{"delta_tracking": {}}"#).expect("a sampler");
    let FreePathClaims { lookups, lookups_error, .. } = tracking.claims(medium);
    close(lookups.expect("known"), due, 1e-11, what);
    assert!(lookups_error <= 1e-9 * due, "{what:?}: {lookups_error:e}");
}

/// Peak, center, width and (base + peak) int_0^2 exp(-tau), by mpmath 1.3 with 50 digits.
const BUMPS: [(f64, f64, f64, f64); 12] = [
    (4.0, 0.9, 0.1, 4.0966519990305349),
    (4.0, 0.9, 0.01, 5.4573885755082113),
    (4.0, 1.31416, 0.001, 5.6755734024648471),
    (4.0, 1.31416, 0.0003, 5.6850173266791481),
    (4.0, 0.0371, 0.0001, 5.683549485962902),
    (4.0, 1.99, 0.0003, 5.6890351829812979),
    (400.0, 0.9, 0.1, 221.93140590804463),
    (400.0, 0.9, 0.01, 286.406815738867),
    (400.0, 1.31416, 0.001, 429.98048446419375),
    (400.0, 1.31416, 0.0003, 475.01517105613339),
    (400.0, 0.0371, 0.0001, 459.42795059965255),
    (400.0, 1.99, 0.0003, 505.94389529359655),
];

#[test]
fn the_look_ups_through_a_narrow_bump_are_those_of_50_digits() {
    for (peak, center, width, due) in BUMPS {
        check(&Gaussian::new(peak, center, width, LENGTH, BASE).expect("a medium"), due, &(peak, center, width));
    }
}

#[test]
fn the_look_ups_of_a_steep_decay_are_the_closed_form() {
    for mu in [1e-3, 1.0, 5e3, 1e6, 1e9] {
        check(&Constant::new(mu, LENGTH).expect("a medium"), -libm::expm1(-mu * LENGTH), &mu);
    }
    for width in [1e-6, 1e-4, 0.01] {
        let (start, mu) = (1.31416, 1e7);
        let medium = BoxSpike::new(BASE, mu, start, start + width, LENGTH).expect("a medium");
        let through = |mu: f64, length: f64| -libm::expm1(-mu * length) / mu;
        let (before, inside) = (libm::exp(-BASE * start), libm::exp(-mu * width));
        let last = before * inside * through(BASE, LENGTH - start - width);
        check(&medium, mu * (through(BASE, start) + before * through(mu, width) + last), &width);
    }
}

#[test]
fn the_look_ups_in_a_thin_atmosphere_are_the_closed_form() {
    // a depth of mu0 h(1 - e^(-t/h)) = 1e-6 at most: int T = L - int tau, to the square of it
    for height in [1e-4, 1e-3, 0.01] {
        let mu0 = 1e-6 / height;
        let medium = Exponential::new(mu0, height, LENGTH).expect("a medium");
        let depth = 1e-6 * (LENGTH - height * -libm::expm1(-LENGTH / height));
        check(&medium, mu0 * (LENGTH - depth + 0.5e-12 * (LENGTH - 1.5 * height)), &height);
    }
}

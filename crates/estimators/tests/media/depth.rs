//! The optical depth of every medium, and its inverse.

use crate::places::places;
use crate::zoo::zoo;
use freepath_draws::quadrature;
use freepath_estimators::medium::numeric;
use freepath_estimators::{Extinction, Majorants, Medium};
use std::sync::Arc;

#[test]
fn tau_is_the_integral_of_mu() {
    for (name, medium) in zoo() {
        let total = medium.tau(medium.length());
        for t in places(&medium, 37) {
            let want = quadrature::integrate(&|s| medium.mu(s), 0.0, t, medium.breaks()).value;
            let slack = 1e-11 * want + 1e-15 * total;
            assert!((medium.tau(t) - want).abs() <= slack, "{name} at {t}");
        }
        assert!(medium.tau(0.0).abs() <= 1e-15 * total, "{name}");
        assert!(medium.tau_error() <= 1e-12 * total, "{name}");
    }
}

#[test]
fn tau_is_monotone_and_additive() {
    for (name, medium) in zoo() {
        let total = medium.tau(medium.length());
        for pair in places(&medium, 2000).windows(2) {
            let step = medium.tau(pair[1]) - medium.tau(pair[0]);
            assert!(step >= -4e-16 * total, "{name} at {}: {step}", pair[0]);
        }
        for pair in places(&medium, 11).windows(2) {
            let step = medium.tau(pair[1]) - medium.tau(pair[0]);
            let want = quadrature::integrate(&|s| medium.mu(s), pair[0], pair[1], medium.breaks()).value;
            assert!((step - want).abs() <= 1e-11 * want + 2e-15 * total, "{name} at {}", pair[0]);
        }
    }
}

#[test]
fn the_inverse_of_tau_reaches_the_depth() {
    for (name, medium) in zoo() {
        let total = medium.tau(medium.length());
        for i in 1..1000 {
            let depth = total * f64::from(i) / 1000.0;
            let t = medium.inverse_tau(depth);
            assert!(t >= 0.0 && t <= medium.length(), "{name}: {t}");
            let miss = (medium.tau(t) - depth).abs();
            assert!(miss <= 1e-12 * depth, "{name} at {depth}: {miss}");
        }
        for exponent in 4..12 {
            let depth = total * 10f64.powi(-exponent);
            let miss = (medium.tau(medium.inverse_tau(depth)) - depth).abs();
            assert!(miss <= 1e-12 * depth + 1e-15 * total, "{name} at {depth}: {miss}");
        }
    }
}

#[test]
fn the_inverse_of_tau_knows_both_ends() {
    for (name, medium) in zoo() {
        let total = medium.tau(medium.length());
        assert!(medium.inverse_tau(0.0) == 0.0, "{name}");
        assert!(medium.inverse_tau(5e-324) < 1e-2 * medium.length(), "{name}");
        assert!(medium.inverse_tau(total.next_down()) <= medium.length(), "{name}");
        for depth in [total, 1.5 * total, f64::INFINITY] {
            assert!(medium.inverse_tau(depth).is_infinite(), "{name} at {depth}");
        }
    }
}

#[test]
fn the_provided_inverse_survives_gaps_where_mu_is_zero() {
    struct Gap(Majorants);
    impl Extinction for Gap {
        fn length(&self) -> f64 {
            3.0
        }
        fn mu(&self, t: f64) -> f64 {
            if (1.0..2.0).contains(&t) || t < 0.25 { 0.0 } else { 2.0 }
        }
        fn majorants(&self) -> &Majorants {
            &self.0
        }
        fn breaks(&self) -> &[f64] {
            &[0.25, 1.0, 2.0]
        }
    }
    impl Medium for Gap {
        fn extrema(&self, _a: f64, _b: f64) -> (f64, f64) {
            (0.0, 2.0)
        }
    }
    let medium = Gap(Majorants::constant(2.0, 3.0));
    for (depth, want) in [(1e-9, 0.25 + 5e-10), (1.0, 0.75), (1.5, 1.0), (1.500_002, 2.000_001), (3.0, 2.75)] {
        assert!((medium.inverse_tau(depth) - want).abs() < 1e-14, "{depth}");
    }
    assert!(medium.inverse_tau(3.5).is_infinite());
    let wrapped = Arc::new(numeric(move |t| medium.mu(t), 3.0, 2.0, vec![0.25, 1.0, 2.0]).unwrap());
    assert!((wrapped.inverse_tau(1.4) - 0.95).abs() < 1e-14);
}

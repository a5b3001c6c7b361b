//! Uniforms at their extremes.

use crate::subject::{Estimator, LENGTH, caught, estimator, in_medium, of_estimator, sinusoid, spike, tracking};
use freepath_estimators::claims::TransmittanceClaims;
use freepath_estimators::medium::{Constant, Sinusoid};
use freepath_estimators::{Extinction, FreePath, FreePathSampler, Majorants, Medium};
use freepath_results::Reason;
use rand::{Rng, RngExt};

#[test]
fn a_logarithm_at_the_closed_end_is_seen() {
    let wrong = |medium: &dyn Extinction, rng: &mut dyn Rng| tracking(medium, rng, |rng| -libm::log(rng.random()));
    let right = |medium: &dyn Extinction, rng: &mut dyn Rng| {
        tracking(medium, rng, |rng| -libm::log1p(-rng.random::<f64>()))
    };
    for medium in [&spike() as &dyn Medium, &sinusoid()] {
        assert!(caught("scripted", Reason::NonFinite, &in_medium(&wrong, medium)));
        assert_eq!(in_medium(&right, medium), []);
    }
}

#[test]
fn a_closed_upper_end_is_seen() {
    let closed = |medium: &dyn Extinction, rng: &mut dyn Rng| {
        let u = ((rng.next_u64() >> 11) + 1) as f64 * 2f64.powi(-53); // in (0, 1]
        let t = -libm::log1p(-u) / medium.mu(0.0);
        if t < medium.length() { t } else { f64::INFINITY }
    };
    let medium = Constant::new(1.3, LENGTH).expect("a medium");
    assert!(caught("scripted", Reason::NonFinite, &in_medium(&closed, &medium)));
}

#[test]
fn a_null_probability_that_rounds_to_something_is_seen() {
    // pa + ps is 1 but for rounding in single precision, where mu_bar is mu: the null branch divides 0 by 0.
    let medium = Constant::new(1.3, LENGTH).expect("a medium");
    struct Rounded;
    impl FreePathSampler for Rounded {
        fn sample(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
            let (mut t, mut weight, rate) = (0.0, 1.0, medium.majorants().mu_bar_at(0.0));
            loop {
                t -= libm::log1p(-rng.random::<f64>()) / rate;
                if !(t < medium.length()) {
                    return FreePath { t: f64::INFINITY, weight, collisions: 0 };
                }
                let null = rate - medium.mu(t);
                let real = 1.0f32 - f32::EPSILON / 2.0; // pa + ps
                if rng.random::<f32>() < real {
                    return FreePath { t, weight, collisions: 0 };
                }
                weight *= null / null;
            }
        }
    }
    assert!(caught("scripted", Reason::NonFinite, &in_medium(&Rounded, &medium)));
}

#[test]
fn a_step_of_zero_that_reads_as_unset_is_seen() {
    let hangs = |medium: &dyn Extinction, rng: &mut dyn Rng| {
        let (mut t, rate) = (0.0, medium.majorants().mu_bar_at(0.0));
        let mut step = -libm::log1p(-rng.random::<f64>()) / rate;
        while t < medium.length() {
            if step == 0.0 {
                medium.mu(t); // no step chosen: tries again
                continue;
            }
            t += step;
            if rng.random::<f64>() < medium.mu(if t < medium.length() { t } else { 0.0 }) / rate {
                return if t < medium.length() { t } else { f64::INFINITY };
            }
            step = -libm::log1p(-rng.random::<f64>()) / rate;
        }
        f64::INFINITY
    };
    let escapes = |medium: &dyn Extinction, rng: &mut dyn Rng| {
        let t = -libm::log1p(-rng.random::<f64>()) / medium.mu(0.0);
        if t < medium.length() && t != 0.0 { t } else { f64::INFINITY }
    };
    let medium = Constant::new(1.3, LENGTH).expect("a medium");
    assert!(caught("scripted", Reason::SubjectError, &in_medium(&hangs, &medium)));
    assert!(caught("scripted", Reason::NonFinite, &in_medium(&escapes, &medium)));
}

#[test]
fn an_overshoot_carried_from_infinity_is_seen_in_the_weight() {
    let carry = estimator(|medium: &dyn Extinction, rng: &mut dyn Rng| {
        let mut depth = -libm::log(rng.random::<f64>()); // infinite at 0
        let mut weight = 1.0;
        for ((start, end), mu_bar) in medium.majorants().segments().zip(medium.majorants().mu_bar()) {
            let mut t = start;
            while depth <= mu_bar * (end - t) {
                t += depth / mu_bar;
                weight *= 1.0 - medium.mu(t) / mu_bar;
                depth = -libm::log(rng.random::<f64>());
            }
            depth -= mu_bar * (end - t);
            weight *= 1.0 + 0.0 * depth;
        }
        weight
    });
    let truth = spike();
    let seen = freepath_estimators::Under::new(std::sync::Arc::new(spike()), Majorants::tight(&truth, 3));
    let facts = of_estimator(&carry, &seen);
    assert!(caught("scripted", Reason::NonFinite, &facts));
}

#[test]
fn a_look_up_beyond_the_ray_is_seen_at_the_extremes() {
    let beyond = |medium: &dyn Extinction, rng: &mut dyn Rng| {
        let t = -libm::log1p(-rng.random::<f64>()) / medium.majorants().mu_bar_at(0.0);
        if t > 20.0 * medium.length() {
            medium.mu(t);
        }
        tracking(medium, rng, |rng| -libm::log1p(-rng.random::<f64>()))
    };
    let medium = Sinusoid::new(0.7, 0.9, 2.0, 0.8, 0.7).expect("a medium");
    assert!(caught("scripted", Reason::OutOfSupport, &in_medium(&beyond, &medium)));
}

/// `u <= mu / mu_bar` accepts u = 0 where mu is 0.
#[test]
fn a_collision_in_vacuum_is_seen() {
    let accepting = |closed: bool| {
        move |medium: &dyn Extinction, rng: &mut dyn Rng| {
            let (mut t, rate) = (0.0, medium.majorants().mu_bar_at(0.0));
            loop {
                t -= libm::log1p(-rng.random::<f64>()) / rate;
                if !(t < medium.length()) {
                    return f64::INFINITY;
                }
                let (u, share) = (rng.random::<f64>(), medium.mu(t) / rate);
                if u < share || (closed && u <= share) {
                    return t;
                }
            }
        }
    };
    assert_eq!(in_medium(&accepting(false), &sinusoid()), []);
    let facts = in_medium(&accepting(true), &sinusoid());
    assert!(caught("scripted", Reason::OutOfSupport, &facts));
    assert!(facts.iter().any(|fact| fact.words.contains("in a medium that is empty")), "{facts:?}");
}

#[test]
fn an_estimate_in_vacuum_that_is_not_one_is_seen() {
    let hits = |closed: bool| {
        let estimate = move |medium: &dyn Extinction, rng: &mut dyn Rng| {
            let (mut t, rate) = (0.0, medium.majorants().mu_bar_at(0.0));
            loop {
                t -= libm::log1p(-rng.random::<f64>()) / rate;
                if !(t < medium.length()) {
                    return 1.0;
                }
                let (u, share) = (rng.random::<f64>(), medium.mu(t) / rate);
                if u < share || (closed && u <= share) {
                    return 0.0;
                }
            }
        };
        let claims = TransmittanceClaims { range: Some((0.0, 1.0)), ..TransmittanceClaims::default() };
        of_estimator(&Estimator(estimate, claims), &sinusoid())
    };
    assert_eq!(hits(false), []);
    assert!(caught("scripted", Reason::OutOfSupport, &hits(true)));
}

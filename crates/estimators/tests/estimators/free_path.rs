//! Free-path samplers against their own claims.

use crate::media::{Counted, bump, constant, cubics, ramp, ramps, steps, zoo};
use freepath_draws::random::{Script, exponential};
use freepath_draws::simd::{self, Isa};
use freepath_draws::{Draws, Key, Row, Streams, column};
use freepath_estimators::free_path::AnyFreePath;
use freepath_estimators::{Cells, Extinction, Medium};

const ROWS: usize = 200_000;

/// One of each kind, by the names that a case uses, as far as they accept the medium.
pub(crate) fn all(medium: &dyn Medium) -> Vec<AnyFreePath> {
    let json = r#"[
        {"delta_tracking": {}}, {"delta_tracking": {"form": "carry"}},
        {"regular_tracking": {"cells": "constant"}}, {"regular_tracking": {"cells": "linear"}},
        {"regular_tracking": {"cells": "cubic"}},
        {"ray_marching": {"rule": "left", "steps": 6}}, {"ray_marching": {"rule": "midpoint", "steps": 5}},
        {"ray_marching": {"rule": "jitter", "steps": 1}}, {"ray_marching": {"rule": "jitter", "steps": 7}},
        {"ray_marching": {"rule": "jitter", "steps": 300}}, {"ray_marching": {"rule": "snap", "steps": 5}}
    ]"#;
    let all: Vec<AnyFreePath> = serde_json::from_str(json).unwrap();
    all.into_iter().filter(|x| x.accepts(&medium).is_ok()).collect()
}

pub(crate) fn named(json: &str) -> AnyFreePath {
    serde_json::from_str(json).unwrap()
}

pub(crate) fn streams(block: u64) -> Streams {
    let (seed, subject) = (21, 8);
    Streams::new(Key { seed, subject, block })
}

/// The draws of both paths, and the look-ups of each per draw.
fn draw(sampler: &AnyFreePath, medium: &dyn Medium, rows: usize) -> [(Vec<f64>, f64); 2] {
    let counted = Counted::new(medium);
    let mut block = Draws::new(&Row::new().with_f64(column::T).with_f64(column::WEIGHT), rows);
    sampler.sample_block(&counted, &streams(1), &mut block);
    let in_block = counted.lookups();
    let streams = streams(2);
    let mut rng = streams.rng();
    let scalar = (0..rows).map(|_| sampler.sample(&counted, &mut rng).t).collect();
    let alone = counted.lookups() - in_block;
    assert!(block.f64(column::WEIGHT).unwrap().iter().all(|&w| w == 1.0));
    [(block.f64(column::T).unwrap().to_vec(), in_block / rows as f64), (scalar, alone / rows as f64)]
}

#[test]
fn the_law_and_the_cost_are_as_claimed_on_both_paths() {
    for medium in zoo() {
        let d = medium.length();
        for sampler in all(&*medium) {
            let claims = sampler.claims(&*medium);
            let what = format!("{sampler:?} in {:?}, {:?}", medium.cells(), medium.majorants());
            for (draws, lookups) in draw(&sampler, &*medium, ROWS) {
                let n = ROWS as f64;
                assert!(draws.iter().all(|&t| (t >= 0.0 && t <= d) || t == f64::INFINITY), "{what}");
                for x in [0.11, 0.3, 0.5, 0.73, 0.9, 1.0].map(|s| s * d) {
                    let law = || libm::exp(-medium.tau(x));
                    let p = claims.own_law.as_ref().map_or_else(law, |law| law(x));
                    let beyond = draws.iter().filter(|&&t| t > x).count() as f64;
                    let error = (p * (1.0 - p) / n).sqrt() + 1e-12;
                    let z = (beyond / n - p) / error;
                    assert!(z.abs() < 4.5, "{what}: at {x}, z = {z}");
                }
                let expected = claims.lookups.unwrap();
                let error = 4.5 * (expected * (2.0 + expected) / n).sqrt() + 1e-9;
                assert!((lookups - expected).abs() < error, "{what}: {lookups}, not {expected}");
            }
        }
    }
}

#[test]
fn regular_tracking_is_the_inverse_of_the_optical_depth() {
    let accepted = |medium: &dyn Medium| {
        let names = all(medium).into_iter();
        names.filter(|x| x.name() == "regular_tracking").collect::<Vec<_>>()
    };
    let media: [(&dyn Medium, usize); 6] =
        [(&constant(), 3), (&steps(), 3), (&ramp(), 2), (&ramps(), 2), (&cubics(), 1), (&bump(), 0)];
    for (medium, degrees) in media {
        assert_eq!(accepted(medium).len(), degrees);
        for sampler in accepted(medium) {
            let (streams, twin) = (streams(9), streams(9));
            let (mut rng, mut twin) = (streams.rng(), twin.rng());
            for _ in 0..20_000 {
                let (t, truth) = (sampler.sample(&medium, &mut rng).t, medium.inverse_tau(exponential(&mut twin)));
                assert!(t == truth || (t - truth).abs() < 1e-12, "{sampler:?}: {t}, not {truth}");
            }
        }
    }
}

#[test]
fn the_own_law_of_marching_agrees_with_brute_force() {
    for medium in zoo() {
        let d = medium.length();
        for steps in [1, 3, 8] {
            let h = d / f64::from(steps);
            let survival = |x: f64, v: f64| {
                let inside = |j: i32| ((x / h - f64::from(j)).clamp(0.0, 1.0), h * (f64::from(j) + v));
                let depth = |j: i32| inside(j).0 * h * medium.mu(inside(j).1);
                libm::exp(-(0..steps).map(depth).sum::<f64>())
            };
            for x in [0.0, 0.1, 0.37, 0.5, 0.99, 1.0].map(|s| s * d) {
                let law = |rule: &str| {
                    let json = format!(r#"{{"ray_marching": {{"rule": "{rule}", "steps": {steps}}}}}"#);
                    named(&json).claims(&*medium).own_law.unwrap()(x)
                };
                let n = 200_000;
                let average = |i: i32| survival(x, (f64::from(i) + 0.5) / f64::from(n)) / f64::from(n);
                assert!((law("jitter") - (0..n).map(average).sum::<f64>()).abs() < 2e-5);
                assert!((law("left") - survival(x, 0.0)).abs() < 1e-13);
                assert!((law("midpoint") - survival(x, 0.5)).abs() < 1e-13);
                let points = (x / h + 0.5).floor() * h;
                let last = if points > d { d } else { points };
                assert!((law("snap") - survival(last, 0.5)).abs() < 1e-13);
            }
        }
    }
}

#[test]
fn marching_errors_fall_as_claimed_in_a_smooth_medium() {
    let medium = bump();
    for rule in ["left", "midpoint", "jitter", "snap"] {
        let worst = |steps: usize| {
            let json = format!(r#"{{"ray_marching": {{"rule": "{rule}", "steps": {steps}}}}}"#);
            let (sampler, mut worst) = (named(&json), 0.0);
            let claims = sampler.claims(&medium);
            let law = claims.own_law.unwrap();
            for i in 0..=6000 {
                let x = f64::from(i) / 3000.0;
                let gap = (law(x) - libm::exp(-medium.tau(x))).abs();
                worst = if gap > worst { gap } else { worst };
            }
            (worst, claims.order.unwrap())
        };
        let ((coarse, order), (fine, _)) = (worst(128), worst(256));
        let measured = libm::log2(coarse / fine);
        assert!((measured - order).abs() < 0.1, "{rule}: {measured}");
    }
}

#[test]
fn the_draws_have_the_same_bits_on_every_instruction_set() {
    for medium in [&steps() as &dyn Medium, &bump(), &cubics()] {
        for sampler in all(medium) {
            let bits = Isa::ALL.map(|isa| {
                simd::limit(isa);
                let mut draws = Draws::new(&Row::new().with_f64(column::T), 1000);
                sampler.sample_block(medium, &streams(3), &mut draws);
                draws.f64(column::T).unwrap().iter().map(|x| x.to_bits()).collect::<Vec<_>>()
            });
            assert!(bits[0] == bits[1] && bits[1] == bits[2], "{sampler:?}");
        }
    }
}

#[test]
fn extreme_words_end_on_the_ray() {
    let words = [0, u64::MAX, 1 << 63];
    for medium in zoo() {
        let d = medium.length();
        let starts_empty = medium.mu(0.0) <= 0.0;
        for sampler in all(&*medium) {
            for (word, repeat) in words.into_iter().flat_map(|w| [(w, false), (w, true)]) {
                let endless = word == 0 && repeat && starts_empty && sampler.name() == "delta_tracking";
                if endless {
                    continue; // steps of zero length where nothing collides
                }
                let prefix = vec![word; 70];
                let streams = streams(4).scripted(Script { prefix, repeat }).with_budget(1_000_000);
                let (mut draws, mut rng) = (Draws::new(&Row::new().with_f64(column::T), 300), streams.rng());
                sampler.sample_block(&*medium, &streams, &mut draws);
                let single = sampler.sample(&*medium, &mut rng).t;
                let inside = |&t: &f64| (t >= 0.0 && t <= d) || t == f64::INFINITY;
                assert!(draws.f64(column::T).unwrap().iter().all(inside) && inside(&single), "{sampler:?} {word}");
            }
        }
    }
}

#[test]
fn bad_parameters_are_refused_by_name() {
    let error = |json: &str| serde_json::from_str::<AnyFreePath>(json).unwrap_err().to_string();
    let zero = error(r#"{"ray_marching": {"rule": "snap", "steps": 0}}"#);
    assert!(zero.contains("steps must be 1 to 100000000, not 0"), "{zero}");
    assert!(error(r#"{"ray_marching": {"rule": "comb", "steps": 3}}"#).contains("unknown variant"));
    let curved = error(r#"{"regular_tracking": {"cells": "curved"}}"#);
    assert!(curved.contains("cells must be constant, linear or cubic, not curved"), "{curved}");
    let linear = named(r#"{"regular_tracking": {"cells": "linear"}}"#);
    let refused = linear.accepts(&cubics()).unwrap_err();
    assert_eq!(refused.to_string(), "cells must be at least cubic, as the medium is, not linear");
    assert_eq!(bump().cells(), Cells::Curved);
    assert_eq!(linear.accepts(&bump()).unwrap_err().name(), "cells");
    for x in all(&constant()) {
        let json = serde_json::to_string(&x).unwrap();
        assert_eq!(named(&json), x, "a parameter is lost in {json}");
    }
}

//! Transmittance estimators against their own claims, and the claims against brute force.

use crate::media::{Counted, bump, cubics, ramp, steps, zoo};
use freepath_draws::random::Script;
use freepath_draws::simd::{self, Isa};
use freepath_draws::{Draws, Key, Row, Streams, column};
use freepath_estimators::transmittance::AnyTransmittance;
use freepath_estimators::{Extinction, Majorants, Medium, Under};

const ROWS: usize = 200_000;

/// One of each kind, by the names that a case uses.
pub(crate) fn all() -> Vec<AnyTransmittance> {
    let json = r#"[
        {"delta_tracking": {}}, {"delta_tracking": {"form": "carry"}}, {"ratio_tracking": {}},
        {"ratio_roulette": {"rule": "pbrt_v3"}}, {"ratio_roulette": {"rule": "pbrt_v4"}},
        {"residual_ratio_tracking": {"control": "mean"}}, {"residual_ratio_tracking": {"control": "minimum"}},
        {"residual_ratio_tracking": {"control": {"value": 0.8}}},
        {"ray_marching": {"rule": "midpoint", "steps": 7}}, {"ray_marching": {"rule": "comb", "steps": 1}},
        {"ray_marching": {"rule": "comb", "steps": 5}}, {"ray_marching": {"rule": "comb", "steps": 33}},
        {"ray_marching": {"rule": "stratified", "steps": 3}}, {"ray_marching": {"rule": "stratified", "steps": 9}}
    ]"#;
    serde_json::from_str(json).unwrap()
}

pub(crate) fn named(json: &str) -> AnyTransmittance {
    serde_json::from_str(json).unwrap()
}

pub(crate) fn streams(block: u64) -> Streams {
    let (seed, subject) = (20, 7);
    Streams::new(Key { seed, subject, block })
}

/// The draws of both paths, and the look-ups of each per draw.
pub(crate) fn draw(estimator: &AnyTransmittance, medium: &dyn Medium, rows: usize) -> [(Draws, f64); 2] {
    let counted = Counted::new(medium);
    let mut block = Draws::new(&Row::new().with_f64(column::WEIGHT).with_u32(column::COLLISIONS), rows);
    estimator.estimate_block(&counted, &streams(1), &mut block);
    let in_block = counted.lookups();
    let (streams, mut scalar) = (streams(2), Draws::new(&Row::new().with_f64(column::WEIGHT), rows));
    let mut rng = streams.rng();
    for weight in scalar.f64_mut(column::WEIGHT).unwrap() {
        *weight = estimator.estimate(&counted, &mut rng);
    }
    let alone = counted.lookups() - in_block;
    [(block, in_block / rows as f64), (scalar, alone / rows as f64)]
}

/// The z of the mean of x^k, from exact moments; draws of no variance must meet it to rounding.
fn z(draws: &[f64], moments: &[f64; 6], k: usize) -> f64 {
    let (mean, square) = (moments[k - 1], moments[2 * k - 1]);
    let found = draws.iter().map(|x| x.powi(k as i32) - mean).sum::<f64>() / draws.len() as f64;
    let variance = square - mean * mean;
    if variance < 1e-11 * square {
        if found.abs() < 1e-6 * mean { 0.0 } else { f64::NAN }
    } else {
        found / (variance / draws.len() as f64).sqrt()
    }
}

#[test]
fn three_moments_range_and_cost_are_as_claimed_on_both_paths() {
    for medium in zoo() {
        for estimator in all() {
            let claims = estimator.claims(&*medium);
            let transmittance = libm::exp(-medium.tau(medium.length()));
            let what = format!("{estimator:?} in {:?}, {:?}", medium.cells(), medium.majorants());
            for (draws, lookups) in draw(&estimator, &*medium, ROWS) {
                if let Some(moments) = claims.moments {
                    let mean = claims.own_mean.unwrap_or(transmittance);
                    assert!((moments[0] - mean).abs() < 1e-12 * mean, "{what}");
                    for k in 1..=3 {
                        let z = z(draws.f64(column::WEIGHT).unwrap(), &moments, k);
                        assert!(z.abs() < 4.5, "{what}: moment {k}, z = {z}");
                    }
                }
                if let Some((low, high)) = claims.range {
                    let outside = |x: &&f64| !(**x >= low - 1e-15 && **x <= high * (1.0 + 1e-12));
                    assert_eq!(draws.f64(column::WEIGHT).unwrap().iter().find(outside), None, "{what}");
                }
                if let Some(expected) = claims.lookups {
                    let error = 4.5 * (expected * (2.0 + expected) / ROWS as f64).sqrt() + 1e-9;
                    assert!((lookups - expected).abs() < error, "{what}: {lookups}, not {expected}");
                }
                assert!(
                    !claims.binary || draws.f64(column::WEIGHT).unwrap().iter().all(|&x| x == 0.0 || x == 1.0)
                );
            }
        }
    }
}

#[test]
fn the_count_of_a_walk_that_never_stops_is_poisson() {
    for medium in zoo() {
        for estimator in all() {
            let claims = estimator.claims(&*medium);
            let Some(mean) = claims.poisson else { continue };
            let [(draws, _), _] = draw(&estimator, &*medium, ROWS);
            let count = |x: &u32| f64::from(*x) - mean;
            let excess = draws.u32(column::COLLISIONS).unwrap().iter().map(count).sum::<f64>() / ROWS as f64;
            let spread = draws.u32(column::COLLISIONS).unwrap().iter().map(|x| count(x) * count(x)).sum::<f64>()
                / ROWS as f64;
            assert!(excess.abs() <= 4.5 * (mean / ROWS as f64).sqrt() + 1e-9);
            let error = ((mean + 2.0 * mean * mean) / ROWS as f64).sqrt();
            assert!((spread - mean).abs() <= 4.5 * error + 1e-9, "{estimator:?}");
        }
    }
}

#[test]
fn ratio_and_roulette_need_no_bounding_majorant_but_pbrt_v3_does() {
    let short = |mu_bar| Under::new(ramp(), Majorants::constant(mu_bar, 2.0).measured(&ramp()));
    let (medium, truth) = (short(1.6), libm::exp(-3.2));
    let mean = |json: &str| {
        let [(draws, _), _] = draw(&named(json), &medium, 1_000_000);
        let n = draws.f64(column::WEIGHT).unwrap().len() as f64;
        let mean = draws.f64(column::WEIGHT).unwrap().iter().sum::<f64>() / n;
        let square = draws.f64(column::WEIGHT).unwrap().iter().map(|x| x * x).sum::<f64>() / n;
        (mean - truth) / ((square - mean * mean) / n).sqrt()
    };
    assert!(mean(r#"{"ratio_tracking": {}}"#).abs() < 4.5);
    assert!(mean(r#"{"ratio_roulette": {"rule": "pbrt_v4"}}"#).abs() < 4.5);
    assert!(mean(r#"{"residual_ratio_tracking": {"control": "mean"}}"#).abs() < 4.5);
    assert!(mean(r#"{"ratio_roulette": {"rule": "pbrt_v3"}}"#) > 6.0);
    assert!(!named(r#"{"ratio_roulette": {"rule": "pbrt_v4"}}"#).claims(&medium).bounded);
    assert!(named(r#"{"ratio_roulette": {"rule": "pbrt_v3"}}"#).claims(&medium).bounded);
}

#[test]
fn the_draws_have_the_same_bits_on_every_instruction_set() {
    for medium in [&steps() as &dyn Medium, &bump(), &cubics()] {
        for estimator in all() {
            let bits = Isa::ALL.map(|isa| {
                simd::limit(isa);
                let mut draws = Draws::new(&Row::new().with_f64(column::WEIGHT), 1000);
                estimator.estimate_block(medium, &streams(3), &mut draws);
                draws.f64(column::WEIGHT).unwrap().iter().map(|x| x.to_bits()).collect::<Vec<_>>()
            });
            assert!(bits[0] == bits[1] && bits[1] == bits[2], "{estimator:?}");
        }
    }
}

#[test]
fn extreme_words_end_in_a_number_in_range() {
    let middle = 1 << 63;
    for medium in zoo() {
        for estimator in all() {
            for (prefix, repeat) in [
                (vec![0; 9], false),
                (vec![u64::MAX; 70], false),
                (vec![middle; 70], false),
                (vec![u64::MAX, 0], false),
                (vec![u64::MAX], true),
                (vec![middle], true),
            ] {
                let script = Script { prefix, repeat };
                let streams = streams(4).scripted(script).with_budget(1_000_000);
                let (mut draws, mut rng) = (Draws::new(&Row::new().with_f64(column::WEIGHT), 300), streams.rng());
                estimator.estimate_block(&*medium, &streams, &mut draws);
                let single = estimator.estimate(&*medium, &mut rng);
                let (low, high) = estimator.claims(&*medium).range.unwrap_or((-1e9, 1e9));
                let inside = |x: &f64| *x >= low - 1e-15 && *x <= high * (1.0 + 1e-12);
                assert!(draws.f64(column::WEIGHT).unwrap().iter().all(inside) && inside(&single), "{estimator:?}");
            }
        }
    }
}

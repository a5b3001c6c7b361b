//! Every test keeps its level: over many seeds its p-values are never below uniform.

use freepath_estimators::free_path::DeltaTracking;
use freepath_estimators::medium::Constant;
use freepath_estimators::random::uniform;
use freepath_estimators::{Extinction, FreePath, FreePathSampler};
use freepath_harness::special::binomial_sf;
use freepath_harness::subject::{Scene, Subject, Work};
use freepath_tests::{judgement, parse, results};
use std::collections::BTreeMap;

const SEEDS: u64 = 150;

/// Right subjects of every kind, at four blocks each.
const CASES: [&str; 4] = [
    r#"{
      "title": "level", "draws": 65536,
      "medium": { "sinusoid": { "mean": 1.0, "amplitude": 0.9, "frequency": 2.0, "phase": 0.7, "length": 2.185 } },
      "subjects": [
        { "free_path": { "delta_tracking": {} } },
        { "free_path": { "delta_tracking": { "form": "carry" } }, "majorant": { "segments": 16 } },
        { "free_path": { "ray_marching": { "rule": "jitter", "steps": 64 } }, "expect": "pass" },
        { "transmittance": { "delta_tracking": {} } },
        { "transmittance": { "ratio_tracking": {} } },
        { "transmittance": { "ratio_roulette": { "rule": "pbrt_v3" } } },
        { "transmittance": { "residual_ratio_tracking": { "control": "mean" } } },
        { "transmittance": { "ray_marching": { "rule": "stratified", "steps": 64 } } }
      ] }"#,
    r#"{
      "title": "level of the exposure score", "draws": 131072,
      "medium": { "linear": { "mu0": 1.0, "mu1": 4.0, "length": 2.2 } },
      "subjects": [ { "free_path": { "delta_tracking": {} } } ] }"#,
    r#"{
      "title": "level of skew means", "draws": 65536,
      "medium": { "linear": { "mu0": 0.5, "mu1": 6.0, "length": 2.2 } },
      "subjects": [
        { "transmittance": { "ratio_tracking": {} }, "majorant": { "factor": 1.1 } },
        { "transmittance": { "residual_ratio_tracking": { "control": "minimum" } } }
      ] }"#,
    r#"{
      "title": "level of chromatic weights", "draws": 65536,
      "medium": { "chromatic": { "sigma_t": [0.4, 1.1, 3.0], "sigma_s": [0.3, 1.0, 1.5], "length": 1.7 } },
      "subjects": [ { "chromatic": { "balance": {} } }, { "chromatic": { "power": {} } } ] }"#,
];

/// p-values by test, over all seeds and subjects that claim the truth.
fn p_values() -> BTreeMap<String, Vec<f64>> {
    let mut all: BTreeMap<String, Vec<f64>> = BTreeMap::new();
    for text in CASES {
        let cases = parse(text);
        for seed in 0..SEEDS {
            for result in results(&cases, 1000 + seed).results {
                let biased = result.estimator == "ray_marching";
                let first = result.tests.into_iter().filter(|test| test.stage == 1);
                for test in first.filter(|test| !biased || test.name.starts_with("own_")) {
                    let kept = test.name.trim_start_matches("own_").trim_end_matches(char::is_numeric).to_string();
                    all.entry(kept).or_default().extend(test.p.map(|p| p.0));
                }
            }
        }
    }
    all.insert("mark".into(), (0..SEEDS).filter_map(of_marks).collect());
    all
}

/// A right sampler with a mark.
struct Marked;

impl FreePathSampler for Marked {
    fn sample(&self, medium: &dyn Extinction, rng: &mut dyn rand::Rng) -> FreePath {
        DeltaTracking::default().sample(medium, rng)
    }
    fn marked(&self) -> bool {
        true
    }
    fn sample_marked(&self, medium: &dyn Extinction, rng: &mut dyn rand::Rng) -> (FreePath, f64) {
        (self.sample(medium, rng), uniform(rng))
    }
}

/// The p-value of the marks, under one seed.
fn of_marks(seed: u64) -> Option<f64> {
    let medium = Constant::new(1.3, 2.1).expect("a medium");
    let scene = Scene::Grey { truth: &medium, seen: &medium };
    judgement(&Subject { draws: 16_384, ..Subject::new(Work::FreePath(&Marked), scene) }, 1000 + seed).p("mark")
}

#[test]
fn no_test_rejects_more_often_than_its_level() {
    let all = p_values();
    let mut faults = Vec::new();
    for (name, p) in &all {
        for level in [1e-3, 0.01, 0.05, 0.1, 0.25, 0.5] {
            let below = p.iter().filter(|p| !(**p > level)).count() as u64;
            let chance = binomial_sf(p.len() as u64, level, below);
            if !(chance > 1e-6) {
                faults.push(format!(
                    "{name}: {below} of {} p-values at or below {level} (chance {chance:.1e})",
                    p.len()
                ));
            }
        }
    }
    let wanted = ["exposure", "neyman_", "lag_2_to_", "pairs_", "null_positions", "series", "mark"];
    let made = wanted.map(|name| (name, all.get(name).map_or(0, Vec::len))).into_iter();
    let unseen: Vec<_> = made.filter(|(_, n)| *n < SEEDS as usize).collect();
    assert!(all.len() >= 19 && unseen.is_empty(), "{unseen:?} of {:?}", all.keys());
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

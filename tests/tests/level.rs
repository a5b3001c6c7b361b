//! Every test keeps its level, and so does a run: the short form of `freepath soak`.

use freepath_draws::random::uniform;
use freepath_estimators::free_path::{AnyFreePath, DeltaTracking};
use freepath_estimators::medium::Constant;
use freepath_estimators::{AuxiliaryPath, Extinction, FreePath, FreePathSampler};
use freepath_harness::case::{Limits, Prepared};
use freepath_harness::kind::{FreePathKind, Placed, PlacedRay, PlacedSource, Ray};
use freepath_harness::scene::MediumScene;
use freepath_harness::soak::{Options, quick, seed_of, soak};
use freepath_harness::subject::Subject;
use freepath_results::{Reason, SoakResults};
use freepath_statistics::special::binomial_two_sided;
use freepath_tests::{free_path, judgement, results};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

fn soaked(cases: &[Prepared], runs: u64) -> SoakResults {
    let never = AtomicBool::new(false);
    let (progress, repro) = (&|_, _: &str| (), String::new());
    let options = Options { seed: 7, runs, levels: &[1e-3, 0.05], cancelled: &never, progress, repro };
    soak(cases, &options).unwrap_or_else(|_| panic!("nobody cancels"))
}

fn cases(draws: u64) -> Vec<Prepared> {
    let limits = Limits { draws: Some(draws), ..Limits::default() };
    quick(&limits).unwrap_or_else(|why| panic!("{why}"))
}

#[test]
fn p_values_follow_their_laws_and_alarms_are_as_rare_as_designed() {
    let found = soaked(&cases(65_536), 60);
    let broken: Vec<_> = found.tests.iter().filter(|test| !(test.holds && test.declared)).collect();
    assert!(found.holds, "{broken:?} {:?} {:?}", found.levels, found.facts);
    assert!(found.tests.len() >= 12, "{:?}", found.tests.iter().map(|test| &test.test).collect::<Vec<_>>());
    assert!(found.p_values > 8_000);
}

#[test]
fn a_truth_that_is_not_the_medium_breaks_the_level() {
    let mut cases = cases(65_536);
    let medium =
        |i: usize| cases[i].scene.get().map(|MediumScene(medium)| medium.clone()).expect("one extinction");
    let (seen, truth) = (medium(0), medium(1));
    cases.truncate(1);
    cases[0].subjects.truncate(1);
    assert!(soaked(&cases, 3).holds);
    let source =
        PlacedSource::<FreePathKind>::Sampler(Arc::new(AnyFreePath::DeltaTracking(DeltaTracking::default())));
    cases[0].subjects[0].experiment = Box::new(Placed { source, scene: PlacedRay { truth, seen } });
    let found = soaked(&cases, 3);
    assert!(!found.holds && found.levels.iter().all(|level| level.confirmed.count == 3), "{:?}", found.levels);
}

#[test]
fn a_soaked_run_is_the_run_of_its_seed() {
    let cases = cases(16_384);
    let (run, found) = (results(&cases, seed_of(7, 0)), soaked(&cases, 1));
    let tests = run.results.iter().flat_map(|result| {
        let biased = result.tests.iter().any(|test| test.name.starts_with("own_"));
        result.tests.iter().filter(move |test| test.stage == 1 && !(biased && test.reason == Reason::Biased))
    });
    let mut p: Vec<f64> = tests.filter_map(|test| test.p).map(|p| p.0).collect();
    assert_eq!(found.p_values, p.len() as u64);
    p.retain(|p| *p <= 0.1);
    let below: f64 = found.tests.iter().map(|test| test.shares[0].0 * test.p_values as f64).sum();
    assert!((below - p.len() as f64).abs() < 1e-6, "{below} {}", p.len());
}

#[test]
fn threads_make_no_difference() {
    let cases = Arc::new(cases(16_384));
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads start");
        serde_json::to_string(&pool.install(|| soaked(&cases, 9))).expect("results are JSON")
    };
    assert_eq!(with(1), with(3));
}

/// A right sampler with auxiliary numbers, which no case can name.
struct WithAuxiliary;

impl FreePathSampler for WithAuxiliary {
    fn sample(&self, medium: &dyn Extinction, rng: &mut dyn rand::Rng) -> FreePath {
        DeltaTracking::default().sample(medium, rng)
    }
    fn has_auxiliary(&self) -> bool {
        true
    }
    fn sample_with_auxiliary(&self, medium: &dyn Extinction, rng: &mut dyn rand::Rng) -> AuxiliaryPath {
        AuxiliaryPath { path: self.sample(medium, rng), auxiliary: uniform(rng) }
    }
}

#[test]
fn auxiliary_numbers_keep_their_level() {
    let medium = Constant::new(1.3, 2.1).expect("a medium");
    let ray = Ray::of(&medium);
    let experiment = free_path(&WithAuxiliary, ray);
    let subject = Subject { draws: 16_384, ..Subject::new(&experiment) };
    let p: Vec<f64> = (0..300).filter_map(|seed| judgement(&subject, 1000 + seed).p("auxiliary")).collect();
    for level in [0.01, 0.05, 0.25, 0.5, 0.75] {
        let below = p.iter().filter(|p| !(**p > level)).count() as u64;
        assert!(binomial_two_sided(300, level, below) > 1e-4, "{below} of {} at {level}", p.len());
    }
}

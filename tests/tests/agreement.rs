//! Agreement without a truth: it catches what depends on the setting, and keeps its level.

use freepath_draws::random::{exponential, uniform};
use freepath_estimators::claims::{FreePathClaims, TransmittanceClaims};
use freepath_estimators::medium::{Constant, Linear, Sinusoid};
use freepath_estimators::{Extinction, FreePath, FreePathSampler, Medium, TransmittanceEstimator};
use freepath_harness::agree::{Agreement, Other, Variant, agree};
use freepath_harness::collect::{Watch, observe};
use freepath_harness::experiment::Experiment;
use freepath_harness::kind::Ray;
use freepath_harness::subject::Subject;
use freepath_statistics::Evidence;
use freepath_statistics::claim::Withdrawal;
use freepath_statistics::special::binomial_sf;
use freepath_tests::{free_path, parse, results, transmittance};
use rand::Rng;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

const BLOCKS: u64 = 12;

/// A subject that can be put along a ray.
#[derive(Clone, Copy)]
enum Along<'s> {
    Path(&'s dyn FreePathSampler),
    Mean(&'s dyn TransmittanceEstimator),
}

impl<'s> Along<'s> {
    fn ray(self, ray: Ray<'s>) -> Box<dyn Experiment + 's> {
        match self {
            Self::Path(sampler) => Box::new(free_path(sampler, ray)),
            Self::Mean(estimator) => Box::new(transmittance(estimator, ray)),
        }
    }
}

/// The evidence of one agreement, where nobody knows the truth: and nothing else has a p-value below 1e-4.
fn agreement_of(along: Along, truth: &Arc<dyn Medium>, agreement: Agreement) -> Evidence {
    let experiment = along.ray(Ray::of(truth));
    let subject = Subject { without: &[Withdrawal::Truth], ..Subject::new(&*experiment) };
    let (plan, never) = (subject.plan(), AtomicBool::new(false));
    let watch = Watch { cancelled: &never, progress: &|_| () };
    let own = observe(&subject, &plan, 4, 0..BLOCKS, &watch).expect("it draws").tallies;
    let judged = plan.claims.judge(&own);
    assert!(judged.evidence.iter().all(|evidence| evidence.p.is_none_or(|p| p > 1e-4)), "{judged:?}");
    let other = agreement.setting(truth).expect("there is such a setting");
    let variant = Variant { other: Other::Setting(agreement), experiment: along.ray(Ray::of(&other)) };
    let compared = agree(&subject, &plan, &variant, &own, 4, 0..BLOCKS, &watch).expect("it draws");
    assert!(compared.facts.is_empty() && compared.evidence.name == agreement.test(), "{:?}", compared.facts);
    compared.evidence
}

fn of_path(sampler: &dyn FreePathSampler, truth: &Arc<dyn Medium>, agreement: Agreement) -> Evidence {
    agreement_of(Along::Path(sampler), truth, agreement)
}

fn of_mean(estimator: &dyn TransmittanceEstimator, truth: &Arc<dyn Medium>, agreement: Agreement) -> Evidence {
    agreement_of(Along::Mean(estimator), truth, agreement)
}

fn waves() -> Arc<dyn Medium> {
    Arc::new(Sinusoid::new(0.9, 0.8, 1.3, 2.4, 0.9).expect("a medium"))
}

fn rising() -> Arc<dyn Medium> {
    Arc::new(Linear::new(0.3, 1.6, 2.4).expect("a medium"))
}

fn homogeneous() -> Arc<dyn Medium> {
    Arc::new(Constant::new(1.1, 2.3).expect("a medium"))
}

fn rejects(evidence: &Evidence) -> bool {
    evidence.p.is_some_and(|p| !(p > 1e-7))
}

/// Ratio tracking, and what a tentative collision does to the weight.
struct Ratio(fn(f64, f64) -> f64);

impl TransmittanceEstimator for Ratio {
    fn estimate(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> f64 {
        let mut weight = 1.0;
        for ((start, end), rate) in medium.majorants().segments().zip(medium.majorants().mu_bar()) {
            let mut t = start + exponential(rng) / rate;
            while t < end {
                weight *= (self.0)(medium.mu(t) / rate, uniform(rng));
                t += exponential(rng) / rate;
            }
        }
        weight
    }
    fn claims(&self, _truth: &dyn Medium) -> TransmittanceClaims {
        TransmittanceClaims { range: Some((0.0, 1.0)), ..TransmittanceClaims::default() }
    }
}

#[test]
fn ratio_tracking_that_also_kills_depends_on_the_majorant() {
    let (right, wrong) = (Ratio(|p, _| 1.0 - p), Ratio(|p, u| if u < p { 0.0 } else { 1.0 - p }));
    for agreement in [Agreement::Majorant, Agreement::Segments] {
        assert!(rejects(&of_mean(&wrong, &waves(), agreement)), "{agreement:?}");
        assert!(!rejects(&of_mean(&right, &waves(), agreement)), "{agreement:?}");
    }
}

/// Delta tracking, and the bound that a walk at t relies on.
struct Delta(fn(&dyn Extinction, f64) -> (f64, f64));

impl FreePathSampler for Delta {
    fn sample(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
        let mut t = 0.0;
        loop {
            let (rate, end) = (self.0)(medium, t);
            let next = t + exponential(rng) / rate;
            if next >= end && end < medium.length() {
                t = end;
            } else if next >= medium.length() {
                return FreePath::at(f64::INFINITY);
            } else if uniform(rng) < medium.mu(next) / rate {
                return FreePath::at(next);
            } else {
                t = next;
            }
        }
    }
    fn claims<'a>(&'a self, _truth: &'a dyn Medium) -> FreePathClaims<'a> {
        FreePathClaims { bounded: false, ..FreePathClaims::default() }
    }
}

fn segment_at(medium: &dyn Extinction, t: f64) -> (f64, f64) {
    let end = medium.majorants().ends().iter().copied().find(|&end| end > t).unwrap_or(f64::INFINITY);
    (medium.majorants().mu_bar_at(t), end)
}

#[test]
fn a_walk_under_the_first_bound_for_ever_depends_on_the_segments() {
    let wrong = Delta(|medium, _| (medium.majorants().mu_bar_at(0.0), medium.length()));
    assert!(rejects(&of_path(&wrong, &rising(), Agreement::Segments)));
    assert!(!rejects(&of_path(&Delta(segment_at), &rising(), Agreement::Segments)));
}

#[test]
fn a_step_beyond_each_face_depends_on_the_grid() {
    // After each face of a cell the walk goes on a little beyond it.
    let wrong = |medium: &dyn Extinction, rng: &mut dyn Rng| {
        let (mut t, rate) = (0.0, medium.mu(0.0));
        for &end in medium.breaks().iter().chain([&medium.length()]) {
            let next = t + exponential(rng) / rate;
            if next < end {
                return next;
            }
            t = end + 0.01;
        }
        f64::INFINITY
    };
    assert!(rejects(&of_path(&wrong, &homogeneous(), Agreement::Grid)));
    assert!(!rejects(&of_path(&Delta(segment_at), &homogeneous(), Agreement::Grid)));
    assert!(Agreement::Grid.setting(&waves()).is_err_and(|why| why.contains("only a homogeneous medium")));
}

/// exp(-h sum mu) with mu at the start of each of 16 steps.
struct Left;

impl TransmittanceEstimator for Left {
    fn estimate(&self, medium: &dyn Extinction, _: &mut dyn Rng) -> f64 {
        let h = medium.length() / 16.0;
        libm::exp(-h * (0..16).map(|i| medium.mu(h * f64::from(i))).sum::<f64>())
    }
}

#[test]
fn a_rule_that_looks_one_way_depends_on_the_direction() {
    assert!(rejects(&of_mean(&Left, &rising(), Agreement::Reversed)));
    let wrong = |medium: &dyn Extinction, rng: &mut dyn Rng| {
        let (mut depth, h) = (exponential(rng), medium.length() / 16.0);
        for i in 0..16 {
            let here = medium.mu(h * f64::from(i));
            if depth < h * here {
                return h * f64::from(i) + depth / here;
            }
            depth -= h * here;
        }
        f64::INFINITY
    };
    assert!(rejects(&of_path(&wrong, &rising(), Agreement::Reversed)));
    assert!(!rejects(&of_path(&Delta(segment_at), &rising(), Agreement::Reversed)));
}

const LEVEL: [&str; 2] = [
    r#"{
      "title": "level", "draws": 32768, "agree": ["majorant", "segments", "reversed"],
      "medium": { "sinusoid": { "mean": 0.9, "amplitude": 0.8, "frequency": 1.3, "phase": 0.9, "length": 2.4 } },
      "subjects": [
        { "free_path": { "delta_tracking": {} }, "without": ["truth"] },
        { "transmittance": { "delta_tracking": {} }, "without": ["truth"] },
        { "transmittance": { "ratio_tracking": {} }, "without": ["truth"] },
        { "transmittance": { "ratio_roulette": { "rule": "pbrt_v3" } }, "without": ["truth"] }
      ] }"#,
    r#"{
      "title": "level in a grid", "draws": 16384, "agree": ["grid"],
      "medium": { "constant": { "mu": 3.1, "length": 1.7 } }, "majorant": { "factor": 1.2 },
      "subjects": [
        { "free_path": { "delta_tracking": {} }, "without": ["truth"] },
        { "transmittance": { "ratio_tracking": {} }, "without": ["truth"] }
      ] }"#,
];

#[test]
fn agreements_reject_no_more_often_than_their_level() {
    let mut p = Vec::new();
    for text in LEVEL {
        let cases = parse(text);
        for seed in 0..60 {
            for result in results(&cases, 500 + seed).results {
                let agreements =
                    result.tests.iter().filter(|test| test.stage == 1 && test.name.starts_with("agree_"));
                p.extend(agreements.filter_map(|test| test.p.map(|p| p.0)));
            }
        }
    }
    assert!(p.len() > 800, "{}", p.len());
    for level in [1e-3, 0.01, 0.05, 0.1, 0.25, 0.5] {
        let below = p.iter().filter(|p| !(**p > level)).count() as u64;
        let chance = binomial_sf(p.len() as u64, level, below);
        assert!(chance > 1e-6, "{below} of {} p-values at or below {level} (chance {chance:.1e})", p.len());
    }
    let median = p.iter().filter(|p| **p < 0.5).count() as f64 / p.len() as f64;
    assert!(median > 0.3, "{median}: nearly all are large, so that nothing would ever be seen");
}

//! Findings in a subject, and subjects to look at.

use freepath_estimators::claims::TransmittanceClaims;
use freepath_estimators::medium::{BoxSpike, Sinusoid};
use freepath_estimators::{Extinction, FreePathSampler, Medium, TransmittanceEstimator};
use freepath_harness::describe::CHECKS;
use freepath_harness::experiment::Experiment;
use freepath_harness::kind::Ray;
use freepath_harness::noiseless::facts;
use freepath_harness::subject::Subject;
use freepath_results::Reason;
use freepath_statistics::Fact;
use freepath_tests::{free_path, transmittance};
use rand::{Rng, RngExt};

pub(crate) const LENGTH: f64 = 2.1;

pub(crate) fn found(experiment: &dyn Experiment) -> Vec<Fact> {
    let subject = Subject { lookups_per_draw: 20_000, ..Subject::new(experiment) };
    facts(&subject, &subject.plan(), 3)
}

pub(crate) fn in_medium(sampler: &dyn FreePathSampler, medium: &dyn Medium) -> Vec<Fact> {
    found(&free_path(sampler, Ray::of(medium)))
}

pub(crate) fn of_estimator(estimator: &dyn TransmittanceEstimator, medium: &dyn Medium) -> Vec<Fact> {
    found(&transmittance(estimator, Ray::of(medium)))
}

pub(crate) fn spike() -> BoxSpike {
    BoxSpike::new(0.0, 3.0, 0.7, 1.4, LENGTH).expect("a medium")
}

pub(crate) fn sinusoid() -> Sinusoid {
    Sinusoid::new(1.0, 0.9, 2.0, LENGTH, 0.7).expect("a medium")
}

/// `check` says `reason`, and no other check says anything.
pub(crate) fn caught(check: &str, reason: Reason, facts: &[Fact]) -> bool {
    assert!(facts.iter().all(|fact| fact.check == check), "{facts:?}");
    assert!(CHECKS.iter().any(|known| known.name == check));
    facts.iter().any(|fact| fact.reason == reason)
}

/// Delta tracking with a step of one's own.
pub(crate) fn tracking(medium: &dyn Extinction, rng: &mut dyn Rng, step: impl Fn(&mut dyn Rng) -> f64) -> f64 {
    let (mut t, rate) = (0.0, medium.majorants().mu_bar_at(0.0));
    loop {
        t += step(rng) / rate;
        if !(t < medium.length()) {
            return f64::INFINITY;
        }
        if rng.random::<f64>() < medium.mu(t) / rate {
            return t;
        }
    }
}

/// An estimator of one function, and what it claims.
pub(crate) struct Estimator<F>(pub(crate) F, pub(crate) TransmittanceClaims);

impl<F: Fn(&dyn Extinction, &mut dyn Rng) -> f64 + Send + Sync> TransmittanceEstimator for Estimator<F> {
    fn estimate(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> f64 {
        (self.0)(medium, rng)
    }
    fn claims(&self, _truth: &dyn Medium) -> TransmittanceClaims {
        self.1.clone()
    }
}

pub(crate) fn estimator<F: Fn(&dyn Extinction, &mut dyn Rng) -> f64 + Send + Sync>(estimate: F) -> Estimator<F> {
    Estimator(estimate, TransmittanceClaims::default())
}

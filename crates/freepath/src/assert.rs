//! One line in a `cargo test`: the whole battery on a sampler or a medium of your own.

mod integral;
mod scenes;
mod walk;

pub use integral::assert_integral;
pub use scenes::{assert_density, assert_direction, assert_discrete, assert_estimate, assert_table_2d};
pub use walk::assert_walk;

use freepath_estimators::medium;
use freepath_estimators::{ChromaticSampler, FreePathSampler, Medium, TransmittanceEstimator};
use freepath_harness::collect::{Collected, Stopped, Watch, observe};
use freepath_harness::experiment::{Experiment, Plan};
use freepath_harness::kind::{Chromatic, FreePathKind, InScene, Ray, Transmittance};
use freepath_harness::noiseless;
use freepath_harness::subject::{Route, Subject};
use freepath_results::Verdict;
use freepath_statistics::Judged;
use freepath_statistics::decide::{Decision, adjust, decide, suspect};
use std::fmt::Write;
use std::panic::Location;
use std::sync::atomic::AtomicBool;

/// Draws of each route in stage 1: few enough for a build without optimisation.
const DRAWS: u64 = 1 << 17;

/// Look-ups and random words for each draw, all told: one that never ends is stopped within seconds.
const LOOKUPS_PER_DRAW: u64 = 20_000;

/// Panics unless `sampler` draws free paths of `medium`: by its block method and by its scalar one, over escapes,
/// distances, ties, order, look-ups and majorant.
///
/// A wrong alarm has a probability of at most 1e-6 for each of the two methods; the same seed gives the same draws. `FREEPATH_SEED` chooses another
/// seed, `FREEPATH_DRAWS` more draws.
///
/// # Panics
/// With what failed, by how much, with which p-value, and how to replay it.
#[track_caller]
pub fn assert_free_path(sampler: &impl FreePathSampler, medium: &impl Medium) {
    assert_experiment(&InScene::<FreePathKind>::of(sampler, Ray::of(medium)), Location::caller());
}

/// Panics unless the mean of `estimator` is the transmittance of `medium`; see [`assert_free_path`].
///
/// # Panics
/// With what failed, by how much, with which p-value, and how to replay it.
#[track_caller]
pub fn assert_transmittance(estimator: &impl TransmittanceEstimator, medium: &impl Medium) {
    assert_experiment(&InScene::<Transmittance>::of(estimator, Ray::of(medium)), Location::caller());
}

/// Panics unless the weights of `sampler` have the right means in every channel of `medium`, for scattering, in bins of t
/// and at the surface; see [`assert_free_path`].
///
/// # Panics
/// With what failed, by how much, with which p-value, and how to replay it.
#[track_caller]
pub fn assert_chromatic(sampler: &impl ChromaticSampler, medium: &medium::Chromatic) {
    assert_experiment(&InScene::<Chromatic>::of(sampler, medium.medium()), Location::caller());
}

fn assert_experiment(experiment: &dyn Experiment, caller: &Location) {
    if let Err(why) = freepath_draws::simd::check_environment() {
        panic!("{why}");
    }
    let effort = Effort { seed: setting("FREEPATH_SEED", 1), draws: setting("FREEPATH_DRAWS", DRAWS) };
    for route in [Route::Block, Route::Scalar] {
        let subject = Subject { route, ..Subject::new(experiment) };
        let (verdict, mut text) = verify(&subject, effort);
        if verdict != Verdict::Pass {
            let how = if route == Route::Block { "drawn in blocks" } else { "drawn one by one" };
            let test = std::thread::current().name().unwrap_or("NAME").to_string();
            let Effort { seed, draws } = effort;
            let _ = write!(
                text,
                "\n  {how}, at {caller}; replay: FREEPATH_SEED={seed} FREEPATH_DRAWS={draws} cargo test {test}"
            );
            panic!("{text}");
        }
    }
}

/// The number of draws, and their seed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// The seed of all streams.
    pub seed: u64,
    /// Draws of stage 1, instead of the subject's.
    pub draws: u64,
}

/// The verdict on `subject` by its route alone, through both stages, and what was found in words. A draw may make 20,000 look-ups and no
/// more, so that a walk that never ends is stopped within seconds.
#[must_use]
pub fn verify(subject: &Subject, Effort { seed, draws }: Effort) -> (Verdict, String) {
    let subject = Subject { draws, lookups_per_draw: LOOKUPS_PER_DRAW, ..subject.clone() };
    let plan = subject.plan();
    let trial = Trial::run(&subject, &plan, seed);
    let decision = trial.decide();
    (decision.verdict, trial.message(&subject, &decision))
}

/// A whole number from the environment.
///
/// # Panics
/// If it is set to anything else: a replay must not run with another seed in silence.
#[track_caller]
fn setting(name: &str, default: u64) -> u64 {
    match std::env::var(name) {
        Err(_) => default,
        Ok(text) => match text.parse() {
            Ok(number) => number,
            Err(why) => panic!("{name} must be a whole number, not {text:?}: {why}"),
        },
    }
}

/// Both stages of one subject.
struct Trial {
    first: Judged,
    second: Option<Judged>,
    draws: u64,
}

impl Trial {
    fn run(subject: &Subject, plan: &Plan, seed: u64) -> Self {
        let (cancelled, blocks) = (AtomicBool::new(false), Subject::blocks(subject.draws));
        let watch = Watch { cancelled: &cancelled, progress: &|_| () };
        let stage = |blocks| judged(plan, observe(subject, plan, seed, blocks, &watch));
        let mut first = stage(0..blocks);
        first.facts.extend(noiseless::facts(subject, plan, seed));
        let second = suspect(&first).then(|| stage(blocks..3 * blocks));
        Self { first, second, draws: subject.draws }
    }

    fn decide(&self) -> Decision {
        let (first, second) = (adjust([&self.first].into_iter()), adjust(self.second.iter()));
        decide(&first[0], second.first())
    }

    fn message(&self, subject: &Subject, decision: &Decision) -> String {
        let passed = decision.verdict == Verdict::Pass;
        let what = if passed { "no claim is rejected" } else { subject.experiment.wrong() };
        let mut text = format!("{what}: {}\n", decision.verdict);
        for note in &decision.notes {
            let _ = writeln!(text, "  {note}");
        }
        for reason in &decision.reasons {
            let _ = writeln!(text, "  {reason}: {}", reason.words());
        }
        let suspect = if self.second.is_some() { ", then twice as many fresh ones for the suspect" } else { "" };
        let _ = write!(text, "  {} draws{suspect}", self.draws);
        text
    }
}

fn judged(plan: &Plan, collected: Result<Collected, Stopped>) -> Judged {
    match collected {
        Ok(collected) => plan.claims.judge(&collected.tallies),
        Err(Stopped::Subject(why)) => Judged::broken(why),
        Err(Stopped::Cancelled) => Judged::default(),
    }
}

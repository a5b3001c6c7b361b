//! Many runs of right subjects on fresh seeds: how often they raise a false alarm, and how their p-values are distributed.
//!
//! Each run is judged as [`run`](crate::run::run) judges: stage 1, Holm over all its p-values, fresh draws for every suspect.
//! Without what does not tell of chance: the checks without noise, and growth, whose p-value is a bound at every number of draws.

use crate::case::Prepared;
use crate::run::{Cancelled, Progress};
use freepath_results::SoakResults;
use rayon::prelude::*;
use std::sync::atomic::AtomicBool;

mod fold;
mod p_values;
mod quick;
mod record;
mod trial;
mod uniformity;

pub use quick::quick;
pub use record::seed_of;

/// Runs whose p-values are held at a time.
const WAVE: u64 = 64;

/// The settings of a soak beside its cases.
pub struct Options<'a> {
    /// The seed from which each run has its own.
    pub seed: u64,
    /// Full judgements.
    pub runs: u64,
    /// Family-wise errors of the stages where both must reject, in (0, 1): each run is decided by the rule at each of them, on the same draws.
    /// One stage rejects alone at half their squares.
    pub levels: &'a [f64],
    /// Set to cancel.
    pub cancelled: &'a AtomicBool,
    /// Told of progress, and of the run.
    pub progress: &'a (dyn Fn(Progress, &str) + Sync),
    /// The command that gives these results again.
    pub repro: String,
}

/// Runs the right subjects among `cases` again and again: those without a fault that are not stated to fail. One that is
/// biased by design is held to its own law.
///
/// The same for any number of threads; memory does not grow with the runs.
///
/// # Errors
/// If it is cancelled.
pub fn soak(cases: &[Prepared], options: &Options) -> Result<SoakResults, Cancelled> {
    let trials = trial::right(cases);
    let draws: u64 = trials.iter().map(trial::Trial::draws).sum();
    (options.progress)(Progress::Planned(options.runs.saturating_mul(draws)), "");
    let (mut fold, mut start) = (fold::Fold::new(options.levels.len()), 0);
    while start < options.runs {
        let after = start + WAVE;
        let end = if after < options.runs { after } else { options.runs };
        let wave: Vec<_> = (start..end).into_par_iter().map(|run| record::record(&trials, options, run)).collect();
        for record in wave {
            fold.observe(&trials, record?);
        }
        start = end;
    }
    Ok(fold.results(&trials, options))
}

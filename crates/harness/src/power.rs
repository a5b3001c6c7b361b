//! The power of the judgement, measured: how many draws it takes to see each fault, and what sees it.
//!
//! Each subject is judged at 256 draws, 512, .., and at its full effort, each time by both stages, until the failure that
//! its case expects is found. From a block (16,384) on the draws are those of `run --draws N`; below, each block is cut short. The number of
//! draws is that of stage 1; a decision by p-values takes twice as many more in stage 2, one by a fact none.
//!
//! # Errors held
//! A fault counts as caught if it would be caught in a run of [`FAMILY`] p-values whose others are all 1: Holm then asks the least
//! p-value of each stage to be at most 7e-8, or that of one stage alone to be at most 2.5e-11. So a row does not depend on its neighbours, and no fault is seen sooner here than
//! in a run as large as the shipped cases. A row that must stay silent is judged the other way, by Holm over its own p-values
//! alone: were it the only subject, nothing would reject it.

mod outcome;
mod row;
mod words;

use crate::case::Prepared;
use crate::run::{Cancelled, Options};
use freepath_results::{POWER_SCHEMA_VERSION, PowerResults, PowerRow, Real, Verdict};
use freepath_statistics::decide::Levels;
use rayon::prelude::*;

/// The p-values of the run that a fault must be caught in.
pub const FAMILY: usize = 10_000;

/// Every subject of every case, at growing draws: the same for any number of threads.
///
/// Cost: at most twice the draws of a run of the same cases.
///
/// # Errors
/// If it is cancelled.
pub fn power(cases: &[Prepared], options: &Options) -> Result<PowerResults, Cancelled> {
    let all = cases.iter().flat_map(|case| case.subjects.iter().map(move |prepared| (case, prepared)));
    let all: Vec<_> = all.collect();
    let rows: Result<Vec<PowerRow>, Cancelled> =
        all.into_par_iter().map(|(case, prepared)| row::row(case, prepared, options)).collect();
    Ok(PowerResults {
        schema_version: POWER_SCHEMA_VERSION,
        version: env!("CARGO_PKG_VERSION").into(),
        seed: options.seed,
        stage_alpha: Real(Levels::RULE.both),
        alone_alpha: Some(Real(Levels::RULE.alone)),
        family: FAMILY,
        repro: options.repro.clone(),
        rows: rows?,
    })
}

/// The exit code that `results` call for, as for a run: 4 if what is not as expected is inconclusive, else 1.
#[must_use]
pub fn exit_code(results: &PowerResults) -> u8 {
    let surprises: Vec<_> = results.rows.iter().filter(|row| !row.as_expected).collect();
    if surprises.is_empty() {
        0
    } else if surprises.iter().all(|row| row.verdict == Verdict::Inconclusive) {
        4
    } else {
        1
    }
}

//! `power.json`: what it takes to see each planted fault.

use crate::{Real, Reason, Verdict};
use serde::{Deserialize, Serialize};

/// The version of this format. Fields are added, never renamed.
pub const POWER_SCHEMA_VERSION: u32 = 1;

/// The fewest draws that are tried.
pub const FEWEST_DRAWS: u64 = 256;

/// The number of draws that each fault needs to be seen, and by which check or test.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct PowerResults {
    /// [`POWER_SCHEMA_VERSION`].
    pub schema_version: u32,
    /// The version of freepath that wrote it.
    pub version: String,
    /// The seed of all draws.
    pub seed: u64,
    /// The family-wise error of each of the two stages.
    pub stage_alpha: Real,
    /// The family-wise error of each stage where one rejects alone; none in results of before it could.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub alone_alpha: Option<Real>,
    /// A fault is caught as in a run of so many p-values, each of the others 1.
    pub family: usize,
    /// The command that gives these results again.
    pub repro: String,
    /// One for each subject, case and ray, in the order of the cases.
    pub rows: Vec<PowerRow>,
}

/// The result due for a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Role {
    /// It must fail, for the reason that is expected.
    Caught,
    /// Its setting masks its fault: it is hidden from every p-value, and at most a fact tells.
    Hidden,
    /// It is right, though it looks like a fault, and must pass.
    Passes,
    /// Nothing is sure beforehand, or it must stay inconclusive.
    Open,
}

/// One subject in one medium.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct PowerRow {
    /// As in results.json.
    pub id: String,
    /// The case file.
    pub file: String,
    /// The title of the case.
    pub case: String,
    /// The ray of the case, from 0, if it has several.
    pub ray: Option<usize>,
    /// The subject's name.
    pub subject: String,
    /// The estimator's name in `freepath list`.
    pub estimator: String,
    /// The key under which the case names it.
    pub kind: String,
    /// The planted faults with their parameters, in words; empty if there is none.
    pub fault: String,
    /// The medium with its parameters, in words.
    pub medium: String,
    /// The result due for it.
    pub role: Role,
    /// The expectation in words, such as `fail: wrong_law`.
    pub expected: String,
    /// The draws of stage 1 at full effort: whole blocks.
    pub draws: u64,
    /// The fewest draws of stage 1, among the doublings of [`FEWEST_DRAWS`] and the full effort, with the failure that is expected; none
    /// if it is not found at full effort.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub needed: Option<u64>,
    /// The sighting that decided: at the fewest draws of a row that is caught, else at full effort.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub first: Option<Sighting>,
    /// All that fired there, facts first, then tests from the least p-value on.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub fired: Vec<Sighting>,
    /// The draws tried, up to those that were needed, and the full effort.
    pub ladder: Vec<Rung>,
    /// The verdict at full effort.
    pub verdict: Verdict,
    /// Its reasons.
    pub reasons: Vec<Reason>,
    /// True if no p-value fails it at full effort, were it the only subject of the run.
    pub silent: bool,
    /// True if all is as it must be: this decides the exit code.
    pub as_expected: bool,
}

/// A test that rejected in both stages, or a fact.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Sighting {
    /// The test, as `freepath describe` takes it, or the check that saw a fact.
    pub name: String,
    /// True if it is a fact, which needs no p-value.
    pub fact: bool,
    /// The reason that it gives.
    pub reason: Reason,
    /// The p-value of stage 2, before Holm, or that of the stage that rejects alone; none of a fact.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub p: Option<Real>,
}

/// One number of draws.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Rung {
    /// Draws of stage 1; a suspect takes twice as many in stage 2.
    pub draws: u64,
    /// The verdict.
    pub verdict: Verdict,
    /// The least p-value of stage 1, before Holm; none if no test could be made.
    pub least_p: Option<Real>,
    /// The test that gave it.
    pub least: Option<String>,
}

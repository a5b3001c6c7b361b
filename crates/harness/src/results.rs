//! `results.json`: the product. Reports are views of it.

use crate::real::Real;
use crate::verdict::{Reason, Verdict};
use serde::{Deserialize, Serialize};

mod grown;
mod law;
mod mean;
mod medium;
mod power;
mod ranking;

pub use grown::{Grown, GrownOutcome};
pub use law::{Atom, CdfSeries, HistogramSeries, LawResult, LifeTable, ResidualSeries};
pub use mean::{ChannelResult, Efficiency, MeanResult, RunningSeries};
pub use medium::{MediumResult, MediumSeries};
pub use power::{POWER_SCHEMA_VERSION, PowerResults, PowerRow, Role, Rung, Sighting};
pub use ranking::{Ranked, RankedPair, Ranking, Refused};

/// The version of this format. Fields are added, never renamed.
pub const SCHEMA_VERSION: u32 = 1;

/// Most points in a series.
pub const MOST_POINTS: usize = 512;

/// Everything that a run found, in the order of its cases and subjects.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Results {
    /// [`SCHEMA_VERSION`].
    pub schema_version: u32,
    /// The version of freepath that wrote it.
    pub version: String,
    /// The run's seed.
    pub seed: u64,
    /// The designed false-alarm rate of the whole run: at most this probability of one wrong `fail`.
    pub alpha: Real,
    /// The family-wise error of each of the two stages.
    pub stage_alpha: Real,
    /// The level at which intervals, bands, `bound` and `detectable` are given.
    pub reporting_level: Real,
    /// How many p-values the run holds, in stage 1 and stage 2.
    pub p_values: [usize; 2],
    /// The command that gives these results again.
    pub repro: String,
    /// The media, one for each case and ray.
    pub media: Vec<MediumResult>,
    /// One for each subject, case and ray.
    pub results: Vec<SubjectResult>,
    /// The transmittance estimators of each medium by efficiency.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub rankings: Vec<Ranking>,
}

/// What was found of one subject in one medium.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct SubjectResult {
    /// Unique in the run: also the key in timings.json and the anchor in the report.
    pub id: String,
    /// The case file, relative to where the run was started.
    pub file: String,
    /// The title of the case.
    pub case: String,
    /// Which of the case's rays, from 0, if it has several.
    pub ray: Option<usize>,
    /// Index into [`Results::media`].
    pub medium: usize,
    /// The subject's name, unique in the case.
    pub subject: String,
    /// The estimator's name in `freepath list`.
    pub estimator: String,
    /// `free_path`, `transmittance` or `chromatic`.
    pub kind: String,
    /// The subject as the case has it.
    pub parameters: serde_json::Value,
    /// The decision.
    pub verdict: Verdict,
    /// Why, if not a pass: most telling first.
    pub reasons: Vec<Reason>,
    /// One sentence for each reason or gate: what, by how much, with which p-value.
    pub notes: Vec<String>,
    /// What the case, its fault or the claims expected, such as `pass` or `fail: biased`.
    pub expected: String,
    /// Whether the expectation was computed from the claims, not written in the case.
    pub expected_by_design: bool,
    /// Whether the verdict is as expected: this decides the exit code.
    pub as_expected: bool,
    /// Names of planted faults, laid in this order.
    pub faults: Vec<String>,
    /// The setting hides the planted faults from the plain statistical tests.
    #[serde(skip_serializing_if = "std::ops::Not::not", default)]
    pub innocent: bool,
    /// Draws asked for in stage 1.
    pub draws_requested: u64,
    /// Draws taken in stage 1: whole blocks.
    pub draws: u64,
    /// Draws taken in stage 2, 0 if there was none.
    pub draws_stage2: u64,
    /// Rows of a file of samples that were not judged, since fewer were asked for.
    #[serde(skip_serializing_if = "is_zero", default)]
    pub draws_left: u64,
    /// The mean of a transmittance estimator.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub mean: Option<MeanResult>,
    /// The law of a sampler.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub law: Option<LawResult>,
    /// The weighted means of a chromatic sampler.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub channels: Vec<ChannelResult>,
    /// Every test of both stages.
    pub tests: Vec<TestResult>,
    /// What contradicts a claim for certain, in the order in which it was seen.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub facts: Vec<FactResult>,
    /// What the plots draw.
    pub series: Series,
    /// Look-ups of mu per draw, as counted.
    pub lookups: Real,
    /// Look-ups per draw that the estimator claims.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub lookups_expected: Option<Real>,
    /// Look-ups above the majorant, out of range, and not a number.
    pub audit: AuditResult,
    /// Efficiency 1 / (variance x look-ups).
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub efficiency: Option<Efficiency>,
    /// For ray marching: the step count and the order that theory predicts.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub order: Option<OrderResult>,
    /// The command that repeats this subject alone.
    pub repro: String,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
fn is_zero(n: &u64) -> bool {
    *n == 0
}

/// One test in one stage.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct TestResult {
    /// `freepath describe NAME` tells more.
    pub name: String,
    /// 1 or 2.
    pub stage: u8,
    /// The statistic.
    pub statistic: Real,
    /// Degrees of freedom, where the test has them.
    pub dof: Option<Real>,
    /// The p-value; none if the test's gate kept it out of the verdict.
    pub p: Option<Real>,
    /// The p-value is shown and spends no error: the verdict does not use it.
    #[serde(skip_serializing_if = "std::ops::Not::not", default)]
    pub reported: bool,
    /// The p-value after Holm over all tests of the stage.
    pub p_adjusted: Option<Real>,
    /// Rejected at the stage's family-wise error.
    pub rejected: bool,
    /// The reason code that a rejection gives.
    pub reason: Reason,
    /// Why there is no p-value, or what the statistic is made of.
    #[serde(skip_serializing_if = "String::is_empty", default)]
    pub note: String,
}

/// One fact: no p-value, and one is enough.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct FactResult {
    /// What saw it, such as `audit`, `support` or `scripted`.
    pub check: String,
    /// 1 or 2.
    pub stage: u8,
    /// The reason code.
    pub reason: Reason,
    /// What was seen.
    pub words: String,
}

/// What the audit of look-ups recorded over all draws.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
pub struct AuditResult {
    /// All look-ups.
    pub lookups: u64,
    /// Look-ups at which mu exceeded the majorant.
    pub above: u64,
    /// Look-ups outside [0, length].
    pub outside: u64,
    /// Draws that are NaN or, where they may not be, infinite.
    pub non_finite: u64,
    /// Draws outside the support of the law.
    pub out_of_support: u64,
}

/// What plots draw, at most [`MOST_POINTS`] points each.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
pub struct Series {
    /// Empirical minus analytic CDF.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub cdf: Option<CdfSeries>,
    /// Histogram over the analytic density.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub histogram: Option<HistogramSeries>,
    /// Chi-square residuals.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub residuals: Option<ResidualSeries>,
    /// Where along the ray the law breaks.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub life_table: Option<LifeTable>,
    /// Running mean.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub running: Option<RunningSeries>,
}

/// A step-count method and what theory says of its bias: |bias| falls like steps^-order.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct OrderResult {
    /// The rule, such as `midpoint`.
    pub rule: String,
    /// Steps along the ray.
    pub steps: u64,
    /// The predicted order.
    pub predicted: Real,
    /// The bias of its own law, without noise: of the mean, or sup |F_own - F|.
    pub bias: Real,
}

/// `timings.json`: every figure that depends on the clock.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Timings {
    /// The run that these belong to: a hash of results.json.
    pub run: String,
    /// Seconds for the whole run.
    pub seconds: Real,
    /// Worker threads.
    pub jobs: usize,
    /// Instruction set in use.
    pub isa: String,
    /// One for each subject, in the order of the results.
    pub subjects: Vec<SubjectTiming>,
}

/// The time that one subject took.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct SubjectTiming {
    /// [`SubjectResult::id`].
    pub id: String,
    /// Seconds of sampling, summed over threads, without judging.
    pub seconds: Real,
    /// Draws taken in that time.
    pub draws: u64,
    /// What it wrote to standard error, if it is a program: up to 64 KiB.
    #[serde(skip_serializing_if = "String::is_empty", default)]
    pub log: String,
}

use crate::{
    ChannelResult, ClaimResult, Efficiency, LawResult, MeanResult, Real, Reason, Series, Verdict,
    WeightedLawResult,
};
use serde::{Deserialize, Serialize};

/// The findings on one subject in one medium.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct SubjectResult {
    /// Unique in the run: also the key in timings.json and the anchor in the report.
    pub id: String,
    /// The case file, relative to where the run was started.
    pub file: String,
    /// The title of the case.
    pub case: String,
    /// The ray of the case, from 0, if it has several.
    pub ray: Option<usize>,
    /// Index into [`Results::media`](crate::Results::media).
    pub medium: usize,
    /// The subject's name, unique in the case.
    pub subject: String,
    /// The estimator's name in `freepath list`.
    pub estimator: String,
    /// The key under which the case names it: one of [`Results::kinds`](crate::Results::kinds).
    pub kind: String,
    /// The subject as the case has it.
    pub parameters: serde_json::Value,
    /// The decision.
    pub verdict: Verdict,
    /// The reasons, if not a pass: most telling first.
    pub reasons: Vec<Reason>,
    /// One sentence for each reason or gate: what, by how much, with which p-value.
    pub notes: Vec<String>,
    /// The verdict that the case, its fault or the claims expected, such as `pass` or `fail: biased`.
    pub expected: String,
    /// True if the expectation was computed from the claims, not written in the case.
    pub expected_by_design: bool,
    /// True if the verdict is as expected: this decides the exit code.
    pub as_expected: bool,
    /// Names of planted faults, laid in this order.
    pub faults: Vec<String>,
    /// The setting hides the planted faults from the plain statistical tests.
    #[serde(skip_serializing_if = "std::ops::Not::not", default)]
    pub masks_fault: bool,
    /// Draws asked for in stage 1.
    pub draws_requested: u64,
    /// Draws taken in stage 1: whole blocks.
    pub draws: u64,
    /// Draws taken in stage 2, 0 if there was none.
    pub draws_stage2: u64,
    /// Rows of a file of samples that were not judged, since fewer were asked for.
    #[serde(skip_serializing_if = "is_zero", default)]
    pub draws_left: u64,
    /// The claims on it, beside what was found of each; none in results of before they were listed.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub claims: Vec<ClaimResult>,
    /// Of the claim of a mean.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub mean: Option<MeanResult>,
    /// Of the claim of a law.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub law: Option<LawResult>,
    /// Of the claims of weighted means, channel by channel.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub channels: Vec<ChannelResult>,
    /// Of the claims of laws under weights, channel by channel.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub weighted_laws: Vec<WeightedLawResult>,
    /// Every test of both stages.
    pub tests: Vec<TestResult>,
    /// Contradictions of a claim, for certain, in the order in which they were seen.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub facts: Vec<FactResult>,
    /// The series that the plots draw.
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
    /// The p-value by which the test may reject in one stage alone, where that is another.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub p_alone: Option<Real>,
    /// The p-value after Holm over all tests of the stage.
    pub p_adjusted: Option<Real>,
    /// The p-value after Holm over those tests of the stage that may reject alone; none of others.
    #[serde(default)]
    pub p_adjusted_alone: Option<Real>,
    /// Rejected at the stage's family-wise error, where both stages must reject.
    pub rejected: bool,
    /// Rejected at the stage's family-wise error, where one rejects alone.
    #[serde(skip_serializing_if = "std::ops::Not::not", default)]
    pub rejected_alone: bool,
    /// The reason code that a rejection gives.
    pub reason: Reason,
    /// The reason why there is no p-value, or the makings of the statistic.
    #[serde(skip_serializing_if = "String::is_empty", default)]
    pub note: String,
}

impl TestResult {
    /// True if it rejects, if the other stage does or alone.
    #[must_use]
    pub fn rejects(&self) -> bool {
        self.rejected || self.rejected_alone
    }
}

/// One fact: no p-value, and one is enough.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct FactResult {
    /// The check that saw it, such as `audit`, `support` or `scripted`.
    pub check: String,
    /// 1 or 2.
    pub stage: u8,
    /// The reason code.
    pub reason: Reason,
    /// The observation, in words.
    pub words: String,
}

/// The counts of the audit of look-ups over all draws.
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

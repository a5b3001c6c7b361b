use crate::Real;
use serde::{Deserialize, Serialize};

/// The outcome of draws that grew towards a bound.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Grown {
    /// Draws looked at in the end, those of stage 1 included.
    pub draws: u64,
    /// The way in which it ended.
    pub outcome: GrownOutcome,
    /// The bound that was asked for: of |bias|, or of sup |F - F_subject|.
    pub target: Real,
    /// The bound on the error at the reporting level, at whatever number of draws growth ended.
    pub bound: Real,
    /// Against an error of 0, at all numbers of draws at once.
    pub p: Real,
    /// The sequence: `beta_binomial`, `betting`, `empirical_bernstein`, `dkw`, `exact`, or that of an interval at each look.
    pub method: String,
    /// The outcome in a sentence.
    pub note: String,
}

/// The three ends of growth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum GrownOutcome {
    /// The error is below the bound that was asked for.
    Proven,
    /// The error is not 0.
    Rejected,
    /// Neither, when another doubling would pass the budget.
    BudgetEnded,
}

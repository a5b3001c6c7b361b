use crate::Real;
use serde::{Deserialize, Serialize};

/// The estimators of one medium by efficiency, 1 / (variance x look-ups).
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Ranking {
    /// Index into [`Results::media`](crate::Results::media).
    pub medium: usize,
    /// The family-wise error at which one is called better than another.
    pub level: Real,
    /// Those that can be ranked, the most efficient first.
    pub order: Vec<Ranked>,
    /// Every pair of them.
    pub pairs: Vec<RankedPair>,
    /// Those without variance, by id.
    pub exact: Vec<String>,
    /// Those that cannot be ranked.
    pub refused: Vec<Refused>,
}

/// An estimator in a ranking.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Ranked {
    /// Its id among the results.
    pub id: String,
    /// One more than the number of those that are better for certain: equals share a rank.
    pub rank: usize,
    /// Var / T^2 x look-ups per draw: look-ups for a relative error of 1.
    pub work: Real,
    /// Standard error of its logarithm.
    pub error: Real,
    /// The method of that error: `delta` or `bootstrap`.
    pub method: String,
}

/// Two estimators compared.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct RankedPair {
    /// The id of the one that needs less work.
    pub better: String,
    /// The id of the other.
    pub worse: String,
    /// ln of the ratio of their work.
    pub log_ratio: Real,
    /// Limits at 95 %.
    pub low: Real,
    /// As `low`.
    pub high: Real,
    /// Two-sided p-value of equal work.
    pub p: Real,
    /// After Holm over all pairs.
    pub p_adjusted: Real,
    /// The better one may be called so.
    pub decided: bool,
}

/// An estimator that cannot be ranked.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Refused {
    /// Its id among the results.
    pub id: String,
    /// The reason, in words.
    pub why: String,
}

use super::Grown;
use crate::real::Real;
use serde::{Deserialize, Serialize};

/// How far the draws are from the law, and how far they could be.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct LawResult {
    /// The largest gap |F_n - F| over the edges of the fine cells, escapes included.
    pub distance: Real,
    /// sup |F - F_subject| that the draws still allow (Dvoretzky-Kiefer-Wolfowitz; Massart 1990).
    pub bound: Real,
    /// sup |F - F_subject| that would have been seen with 90 % power.
    pub detectable: Real,
    /// The probability of escape.
    pub atom: Atom,
    /// How draws grew towards a bound, if the case asks for one; `bound` is then the one that was reached.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub grown: Option<Grown>,
}

/// The escape atom.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Atom {
    /// exp(-tau(length)).
    pub expected: Real,
    /// The share of draws that escaped.
    pub estimate: Real,
    /// Clopper-Pearson limits at the reporting level.
    pub low: Real,
    /// As `low`.
    pub high: Real,
}

/// Empirical minus analytic CDF at some t, escapes included.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
pub struct CdfSeries {
    /// Where.
    pub t: Vec<Real>,
    /// F_n(t) - F(t).
    pub difference: Vec<Real>,
    /// Half width of the simultaneous band at the reporting level.
    pub band: Real,
    /// F_own(t) - F(t), for a method that is biased by design; else empty.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub own: Vec<Real>,
}

/// Shares of draws in cells of t, as densities, beside the analytic ones.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
pub struct HistogramSeries {
    /// One more than cells.
    pub edges: Vec<Real>,
    /// Observed share / width.
    pub density: Vec<Real>,
    /// Probability / width.
    pub expected: Vec<Real>,
    /// Observed share of escapes.
    pub escape: Real,
    /// Probability of escape.
    pub escape_expected: Real,
}

/// (observed - expected) / sqrt(expected) in the cells of the 64-cell chi-square test; the last is the escape cell, if
/// `escape` says so.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
pub struct ResidualSeries {
    /// One more than the cells without the escape cell.
    pub edges: Vec<Real>,
    /// One for each cell, then one for escape.
    pub residual: Vec<Real>,
    /// Whether the last residual is that of escapes.
    pub escape: bool,
}

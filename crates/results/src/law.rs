use crate::{Grown, Real};
use serde::{Deserialize, Serialize};

/// The distance of the draws from the law, and the bound on it.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct LawResult {
    /// The largest gap |F_n - F| over the edges of the fine cells, escapes included.
    pub distance: Real,
    /// sup |F - F_subject| that the draws still allow (Dvoretzky-Kiefer-Wolfowitz; Massart 1990).
    pub bound: Real,
    /// sup |F - F_subject| that this run would have failed with 90 % power, at the level that its decision left to one test.
    pub detectable: Real,
    /// The smallest relative error of the extinction, the same everywhere, that the exposure score would have failed in this
    /// run with 90 % power; none where the score is withheld.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub detectable_scale: Option<Real>,
    /// The smallest relative error of the probability of one cell, of the 64 of nearly equal probability (fewer if draws are
    /// few), that chi-square would have failed in this run with 90 % power; none where that test is withheld.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub detectable_cell: Option<Real>,
    /// The probability of escape.
    pub atom: Atom,
    /// The growth of draws towards a bound, if the case asks for one; `bound` is then the one that was reached.
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
    /// The distances t.
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
    /// True if the last residual is that of escapes.
    pub escape: bool,
}

/// Table of places along the ray where the law breaks: collisions in each row of t among the draws that reach it. A
/// diagnosis; no verdict uses it.
///
/// Rows follow the medium's breaks or voxels, each moved to the nearest edge of a fine cell (2^-14 of the length or less);
/// where there are fewer than 8 breaks, 16 equal rows are cut as well, and neighbours are joined until there are at most 128.
/// Given the draws at risk, the collisions of a row are binomial with the probability 1 - exp(-(tau(end) - tau(start))).
/// All are judged against the medium's law, also those of a method that is biased by design.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
pub struct LifeTable {
    /// The ends of the rows, in length units: one more than rows. The lists below have one number for each row.
    pub edges: Vec<Real>,
    /// Draws that reach the row's start, escapes included.
    pub at_risk: Vec<u64>,
    /// Draws that collide in the row.
    pub collisions: Vec<u64>,
    /// Collisions expected among those at risk.
    pub expected: Vec<Real>,
    /// Observed over expected hazard, ln(1 - collisions / at_risk) / -(tau(end) - tau(start)): by what factor the extinction
    /// looks too large in this row; "nan" where nothing can be said.
    pub ratio: Vec<Real>,
    /// Exact limits of the ratio (Clopper-Pearson) at the reporting level.
    pub low: Vec<Real>,
    /// As `low`.
    pub high: Vec<Real>,
    /// Exact binomial mid-p, two-sided by doubling, of the row alone: with k rows, one of them below 0.001 / k is worth a look.
    pub p: Vec<Real>,
}

use super::difference::{ROUNDING, excess};
use crate::hypothesis::clt_gate::clt_gate;
use crate::hypothesis::mean_claim::MeanClaim;
use crate::tally::PowerSums;

/// The interval and the test that the draws allow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Exact binomial and Clopper-Pearson (1934).
    Binomial,
    /// No variance: compared up to rounding and the slack.
    Exact,
    /// Student's t.
    StudentT,
    /// Hall's (1992) cubic skewness correction.
    SkewnessCorrected,
    /// Maurer and Pontil (2009), theorem 4.
    EmpiricalBernstein,
    /// Every draw is 1: held against the chance that no draw has met anything yet (Markov).
    AllOnes,
    /// Student's t over the means of batches of rows that may depend.
    BatchMeans,
    /// Nothing that can be trusted.
    None,
}

impl Method {
    /// The name in the results.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Binomial => "binomial",
            Self::Exact => "exact",
            Self::StudentT => "student_t",
            Self::SkewnessCorrected => "skewness_corrected",
            Self::EmpiricalBernstein => "empirical_bernstein",
            Self::AllOnes => "all_ones",
            Self::BatchMeans => "batch_means",
            Self::None => "none",
        }
    }
}

/// The sharpest method that the draws allow.
pub(super) fn method(sums: &PowerSums, claim: &MeanClaim) -> Method {
    if claim.binary && sums.zeros + sums.ones == sums.n && sums.n > 0 {
        return Method::Binomial;
    }
    if exact(sums, claim) {
        return Method::Exact;
    }
    let (plain, corrected) = gate(skewness(sums, claim), sums.n as f64);
    let tame = !sums.constant() && clt_gate(sums).is_none() && range_is_seen(sums, claim);
    match claim.range {
        _ if plain && tame => Method::StudentT,
        _ if corrected && tame => Method::SkewnessCorrected,
        Some(range) if within(sums, range) => Method::EmpiricalBernstein,
        None if sums.n > 0 && sums.ones == sums.n && claim.expected < 1.0 => Method::AllOnes,
        _ => Method::None,
    }
}

/// Most standard errors by which one draw at the end of the range may move the mean.
const UNSEEN: f64 = 0.1;

/// True if what may lie in the range and has not been drawn hardly moves the mean; also where a formula tells how far draws scatter.
fn range_is_seen(sums: &PowerSums, claim: &MeanClaim) -> bool {
    match (claim.range, claim.variance) {
        (Some((low, high)), None) => high - low <= UNSEEN * (sums.variance() * sums.n as f64).sqrt(),
        (None, _) | (Some(_), Some(_)) => true,
    }
}

/// The larger of the sample's and the formula's skewness: a sample that has not seen its tail looks too tame.
pub(super) fn skewness(sums: &PowerSums, claim: &MeanClaim) -> f64 {
    let sample = sums.skewness();
    match claim.skewness {
        Some(exact) if exact.abs() > sample.abs() => exact,
        _ => sample,
    }
}

/// True if skewness allows the plain, and the corrected, statistic.
pub(in crate::hypothesis) fn gate(skewness: f64, n: f64) -> (bool, bool) {
    let g = skewness.abs() / n.sqrt();
    (g <= 0.03, g <= 0.1)
}

/// True if the draws have no noise, so that their value is compared with the truth: not if a formula says that they
/// have, by a variance that is more than cancellation or a skewness, and not if all are 0 or all are 1, as of walks
/// that have met nothing yet.
pub(super) fn exact(sums: &PowerSums, claim: &MeanClaim) -> bool {
    let scale = claim.expected.abs();
    let skew = claim.skewness.is_some_and(|skewness| !skewness.is_nan());
    let noisy = claim.variance.map_or(skew, |v| v > noise(claim));
    let met_nothing = sums.zeros == sums.n || sums.ones == sums.n;
    let still = sums.greatest - sums.least <= ROUNDING * scale;
    let telling = claim.variance.is_some() || !met_nothing || excess(sums, claim) == 0.0;
    still && (scale == 0.0 || (!noisy && telling)) // where nothing is due there is no noise
}

/// True if it is known that the draws have no noise: by a formula or a declaration, or since their mean is an end of their range.
#[must_use]
pub fn noise_free(claim: &MeanClaim) -> bool {
    let MeanClaim { expected, range, variance, .. } = *claim;
    let at_an_end = |(low, high): (f64, f64)| !(low < expected && expected < high);
    expected == 0.0 || variance.is_some_and(|v| v <= noise(claim)) || range.is_some_and(at_an_end)
}

/// The most that cancellation makes of a variance by formula where there is none.
fn noise(claim: &MeanClaim) -> f64 {
    1e-14 * claim.expected * claim.expected
}

/// True if every draw lies in the range, but for rounding.
#[must_use]
pub fn within(sums: &PowerSums, (low, high): (f64, f64)) -> bool {
    let rounding = ROUNDING * (high - low);
    sums.least >= low - rounding && sums.greatest <= high + rounding
}

//! What is claimed of a column of estimates: that they are finite and in their range, their mean, and what their author states of them.

use super::batches;
use crate::experiment::{Declared, Terms};
use freepath_draws::column::WEIGHT;
use freepath_results::Reason;
use freepath_statistics::claim::{
    Binary, BoundedMean, Claims, EnoughRows, Estimates, MeanAgreement, Moments, NoiseFree, OwnMean, Spread,
    StatedSecondMoment, WeightClaim, Withdrawal, bets, bounds, portfolio,
};
use freepath_statistics::fold::{Batched, CapitalSums, FoldId, WealthSums, Weights};
use freepath_statistics::hypothesis::MeanClaim;

/// A variance below it, relative to the square of the mean, is what cancellation leaves of none.
const CANCELLED: f64 = 1e-13;

/// The mean of the estimates, by formulas and by what their author states.
#[derive(Clone, Copy)]
pub(super) struct StatedMean {
    /// The truth.
    pub(super) truth: MeanClaim,
    /// The mean that the estimator has by design, if that is another.
    pub(super) own: Option<MeanClaim>,
}

impl StatedMean {
    /// What formulas know, joined to what is declared; the mean that is declared stands in place of that by formula.
    pub(super) fn new(known: MeanClaim, own: Option<MeanClaim>, terms: &Terms) -> Self {
        let (declared, truth) = (terms.declared, joined(known, terms.declared));
        let by_author = |expected: f64| {
            let variance = declared.second_moment.map(|m2| not_below_zero(m2 - expected * expected));
            MeanClaim {
                expected,
                slack: terms.tolerance,
                variance: declared.variance(variance.or(truth.variance)),
                ..truth
            }
        };
        let own = declared.own_mean.map(by_author).or_else(|| own.map(|own| joined(own, declared)));
        Self { truth, own }
    }

    /// own mean - truth, 0 if the mean is the truth.
    pub(super) fn design_bias(&self) -> f64 {
        self.own.map_or(0.0, |own| own.expected - self.truth.expected)
    }

    /// The fold of the estimates.
    pub(super) fn weights(&self, claims: &mut Claims) -> FoldId<Weights> {
        let keeps_tail = self.truth.range.is_none() && self.truth.variance.is_none();
        claims.folds.add(Weights { column: WEIGHT, center: self.truth.expected, keeps_tail })
    }

    /// Claims that hold whatever the mean.
    pub(super) fn support(&self, weights: FoldId<Weights>, external: bool, terms: &Terms, claims: &mut Claims) {
        let (MeanClaim { expected, range, binary, .. }, tolerance) = (self.truth, terms.tolerance);
        claims.push(Estimates { column: WEIGHT, weights, range, tolerance });
        if terms.declared.binary {
            claims.push(Binary { column: WEIGHT, weights });
        }
        if terms.declared.noise_free {
            claims.push(NoiseFree { weights, rounding: 1e-9 * expected.abs() + tolerance });
        }
        if external {
            claims.push(EnoughRows);
        }
        claims.push(MeanAgreement { weights, spread: Spread { range, binary } });
    }

    /// The mean, the one that the estimator has by design, and the second moment that is stated. A step rule has an order.
    pub(super) fn means(&self, weights: FoldId<Weights>, order: Option<f64>, terms: &Terms, claims: &mut Claims) {
        let Self { truth, own } = *self;
        let fold = |bets| CapitalSums { column: WEIGHT, bets };
        let capitals = bets(&truth, terms.bias_bound).map(|bets| claims.folds.add(fold(bets)));
        claims.push(WeightClaim { weights, truth, own, order, capitals });
        if let Some(mean) = own {
            claims.push(OwnMean { weights, mean });
        }
        in_range("bounded_mean", (truth, Reason::Biased), weights, terms, claims);
        in_batches("mean", (truth, Reason::Biased), weights, terms, claims);
        if let Some(mean) = own {
            in_range("own_bounded_mean", (mean, Reason::WrongLaw), weights, terms, claims);
            in_batches("own_mean", (mean, Reason::WrongLaw), weights, terms, claims);
        }
        if let (Some(expected), Some(range)) = (terms.declared.second_moment, truth.range) {
            claims.push(StatedSecondMoment { weights, expected, range, slack: terms.tolerance });
        }
    }
}

/// Variance and skewness from raw moments: neither where the variance is infinite, no skewness where cancellation leaves no digits of it;
/// an infinite one where the third moment is infinite, or is not known.
pub(super) fn spread(moments: &[f64; 6]) -> (Option<f64>, Option<f64>) {
    let [m1, m2, m3, ..] = *moments;
    if !m2.is_finite() {
        return (None, None);
    }
    let variance = m2 - m1 * m1;
    let third = m3 - 3.0 * m1 * m2 + 2.0 * m1 * m1 * m1;
    let scatters = variance > CANCELLED * m1 * m1;
    let skewness = third / (variance * variance.sqrt());
    let skewness = if m3.is_finite() { skewness } else { f64::INFINITY };
    let skewness = Some(skewness).filter(|skewness| variance > 1e-9 * m1 * m1 && !skewness.is_nan());
    (Some(if scatters { variance } else { 0.0 }), skewness)
}

/// What is known of a mean and what is declared of its draws.
fn joined(known: MeanClaim, declared: Declared) -> MeanClaim {
    let range = declared.range(known.range).or(declared.binary.then_some((0.0, 1.0)));
    let (binary, variance) = (known.binary || declared.binary, declared.variance(known.variance));
    MeanClaim { binary, range, variance, ..known }
}

fn not_below_zero(variance: f64) -> f64 {
    if variance < 0.0 { 0.0 } else { variance }
}

/// The mean by the range of the estimates, if they have one.
fn in_range(
    name: &str,
    (mean, reason): (MeanClaim, Reason),
    weights: FoldId<Weights>,
    terms: &Terms,
    claims: &mut Claims,
) {
    if !bounds(&mean) || !terms.stands(Withdrawal::Independent) {
        return;
    }
    let fold = |portfolio| WealthSums { column: WEIGHT.into(), event: None, portfolio };
    let wealth = portfolio(&mean).map(|portfolio| claims.folds.add(fold(portfolio)));
    claims.push(BoundedMean { name: name.to_string(), sums: Moments::Column(weights), wealth, mean, reason });
}

/// The mean where rows may depend.
fn in_batches(
    name: &str,
    (mean, reason): (MeanClaim, Reason),
    weights: FoldId<Weights>,
    terms: &Terms,
    claims: &mut Claims,
) {
    let (sums, fold) = (Moments::Column(weights), Batched::column(WEIGHT));
    batches::mean((name, reason), sums, fold, mean, terms, claims);
}

use crate::experiment::{Plan, Terms};
use crate::scene::Number;
use freepath_draws::column::WEIGHT;
use freepath_statistics::claim::{Claims, EnoughRows, Estimates, MeanAgreement, Spread, WeightClaim, bets};
use freepath_statistics::fold::{CapitalSums, Weights};
use freepath_statistics::hypothesis::MeanClaim;

/// Estimates are finite, in their range, and have the stated mean.
pub(super) fn plan<'a>(number: &Number, external: bool, terms: &Terms) -> Plan<'a> {
    let (mut claims, truth) = (Claims::default(), mean(number, terms));
    let keeps_tail = truth.range.is_none() && truth.variance.is_none();
    let weights = claims.folds.add(Weights { column: WEIGHT, center: truth.expected, keeps_tail });
    claims.push(Estimates { column: WEIGHT, weights, range: truth.range });
    if external {
        claims.push(EnoughRows);
    }
    claims.push(MeanAgreement { weights, spread: Spread { range: truth.range, binary: truth.binary } });
    let fold = |bets| CapitalSums { column: WEIGHT, bets };
    let capitals = bets(&truth, terms.bias_bound).map(|bets| claims.folds.add(fold(bets)));
    claims.push(WeightClaim { weights, truth, own: None, order: None, capitals });
    Plan { claims, beside: Vec::new() }
}

fn mean(number: &Number, terms: &Terms) -> MeanClaim {
    MeanClaim {
        expected: number.value,
        slack: terms.tolerance,
        binary: false,
        range: number.range.map(|[low, high]| (low, high)),
        variance: number.variance,
        skewness: None,
    }
}

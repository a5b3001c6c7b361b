use super::Estimate;
use crate::experiment::{Plan, Terms};
use crate::kind::column_order::OrderedColumn;
use crate::kind::{Source, batches};
use crate::scene::Number;
use freepath_draws::column::WEIGHT;
use freepath_results::Reason;
use freepath_statistics::claim::{
    BoundedMean, Claims, EnoughRows, Estimates, MeanAgreement, Moments, NoiseFree, Spread, WeightClaim,
    Withdrawal, bets, bounds, portfolio,
};
use freepath_statistics::fold::{Batched, CapitalSums, WealthSums, Weights};
use freepath_statistics::hypothesis::MeanClaim;

/// Estimates are finite, in their range, and have the stated mean.
pub(super) fn plan<'a>(number: &Number, source: &Source<Estimate>, terms: &Terms) -> Plan<'a> {
    let (mut claims, truth) = (Claims::default(), mean(number, source, terms));
    let keeps_tail = truth.range.is_none() && truth.variance.is_none();
    let weights = claims.folds.add(Weights { column: WEIGHT, center: truth.expected, keeps_tail });
    let tolerance = terms.tolerance;
    claims.push(Estimates { column: WEIGHT, weights, range: truth.range, tolerance });
    if terms.declared.noise_free {
        claims.push(NoiseFree { weights, rounding: 1e-9 * truth.expected.abs() + tolerance });
    }
    if source.is_external() {
        claims.push(EnoughRows);
    }
    claims.push(MeanAgreement { weights, spread: Spread { range: truth.range, binary: truth.binary } });
    let fold = |bets| CapitalSums { column: WEIGHT, bets };
    let capitals = bets(&truth, terms.bias_bound).map(|bets| claims.folds.add(fold(bets)));
    claims.push(WeightClaim { weights, truth, own: None, order: None, capitals });
    batches::mean(
        ("mean", Reason::Biased),
        Moments::Column(weights),
        Batched::column(WEIGHT),
        truth,
        terms,
        &mut claims,
    );
    if bounds(&truth) && terms.stands(Withdrawal::Independent) {
        let fold = |portfolio| WealthSums { column: WEIGHT.into(), event: None, portfolio };
        let wealth = portfolio(&truth).map(|portfolio| claims.folds.add(fold(portfolio)));
        let (name, sums, reason) = ("bounded_mean".to_string(), Moments::Column(weights), Reason::Biased);
        claims.push(BoundedMean { name, sums, wealth, mean: truth, reason });
    }
    OrderedColumn::only(WEIGHT).claim(source.is_external(), terms, &mut claims);
    Plan { claims, beside: Vec::new() }
}

fn mean(number: &Number, source: &Source<Estimate>, terms: &Terms) -> MeanClaim {
    let variance = match source {
        Source::Control => Some(0.0),
        Source::Sampler(_) | Source::External(_) => terms.declared.variance(number.variance),
    };
    MeanClaim {
        expected: number.value,
        slack: terms.tolerance,
        binary: false,
        range: terms.declared.range(number.range.map(|[low, high]| (low, high))),
        variance,
        skewness: None,
    }
}

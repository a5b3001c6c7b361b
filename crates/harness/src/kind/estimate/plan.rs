use super::Estimate;
use crate::experiment::{Plan, Terms};
use crate::kind::Source;
use crate::kind::column_order::OrderedColumn;
use crate::kind::stated::StatedMean;
use crate::scene::Number;
use freepath_draws::column::WEIGHT;
use freepath_statistics::claim::Claims;
use freepath_statistics::hypothesis::MeanClaim;

/// Estimates are finite, in their range, and have the stated mean.
pub(super) fn plan<'a>(number: &Number, source: &Source<Estimate>, terms: &Terms) -> Plan<'a> {
    let (mut claims, mean) = (Claims::default(), mean(number, source, terms));
    let weights = mean.weights(&mut claims);
    mean.support(weights, source.is_external(), terms, &mut claims);
    mean.means(weights, None, terms, &mut claims);
    OrderedColumn::only(WEIGHT).claim(source.is_external(), terms, &mut claims);
    Plan { claims, beside: Vec::new() }
}

/// The number, and what is known of its estimates.
pub(super) fn mean(number: &Number, source: &Source<Estimate>, terms: &Terms) -> StatedMean {
    let variance = match source {
        Source::Control => Some(0.0),
        Source::Sampler(_) | Source::External(_) => number.variance,
    };
    let known = MeanClaim {
        expected: number.value,
        slack: terms.tolerance,
        binary: false,
        range: number.range.map(|[low, high]| (low, high)),
        variance,
        skewness: None,
    };
    StatedMean::new(known, None, terms)
}

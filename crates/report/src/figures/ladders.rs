//! Step counts of one rule, put together.

use crate::plot::order::{Ladder, Rung};
use crate::site::Subject;
use crate::text::clean;
use freepath_results::{OrderResult, SubjectResult};
use std::collections::BTreeMap;

/// Fewest step counts that show an order.
const FEWEST: usize = 3;

/// The ladders among the subjects of one case and ray.
pub(crate) fn of(members: &[&Subject]) -> Vec<Ladder> {
    let mut groups: BTreeMap<(&str, &str), Vec<(&OrderResult, &SubjectResult)>> = BTreeMap::new();
    for subject in members.iter().filter(|s| !s.is_control()) {
        if let Some(order) = &subject.result.order {
            let key = (subject.result.kind.as_str(), order.rule.as_str());
            groups.entry(key).or_default().push((order, subject.result));
        }
    }
    groups.into_iter().filter_map(|((_, rule), members)| ladder(rule, members)).collect()
}

fn ladder(rule: &str, mut members: Vec<(&OrderResult, &SubjectResult)>) -> Option<Ladder> {
    members.sort_by_key(|(order, _)| order.steps);
    members.dedup_by_key(|(order, _)| order.steps);
    let (order, first) = members.first()?;
    let measure = if first.mean.is_some() { "bias" } else { "distance from the law" };
    let predicted = order.predicted.0;
    let rungs: Vec<Rung> = members.iter().filter_map(|(order, result)| rung(order, result)).collect();
    let ladder = Ladder { rule: clean(rule, 40), measure, predicted, rungs };
    (ladder.rungs.len() >= FEWEST).then_some(ladder)
}

fn rung(order: &OrderResult, result: &SubjectResult) -> Option<Rung> {
    let (bias, low, high) = match (&result.mean, &result.law) {
        (Some(mean), _) => {
            let (a, b) = (mean.low.0, mean.high.0);
            let low = if a > 0.0 || b < 0.0 { a.abs().min(b.abs()) } else { 0.0 };
            (mean.bias.0.abs(), low, a.abs().max(b.abs()))
        }
        // The band of a distance is as wide below it as above.
        (None, Some(law)) => (law.distance.0, 2.0 * law.distance.0 - law.bound.0, law.bound.0),
        (None, None) => return None,
    };
    let usable = bias.is_finite() && low.is_finite() && high.is_finite() && order.steps > 0;
    usable.then(|| Rung { steps: order.steps as f64, bias, low, high, own: order.bias.0.abs() })
}

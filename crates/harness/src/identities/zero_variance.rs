use super::rows::draw;
use crate::plan::Plan;
use crate::subject::Subject;
use freepath_draws::column;
use freepath_results::Reason;
use freepath_statistics::Fact;

/// Check and words.
pub(super) const CHECK: (&str, &str) = (
    "identity_zero_variance",
    "A fact: where the moments that an estimator claims leave no variance, two estimates must be equal.",
);

/// Estimates that are compared.
const ROWS: usize = 256;

/// Estimates differ where the claims say that they cannot.
pub(super) fn fact(subject: &Subject, plan: &Plan, seed: u64) -> Option<Fact> {
    let mean = plan.mean.as_ref()?;
    let expected = mean.own.map_or(mean.truth.expected, |own| own.expected);
    let still = mean.truth.variance.is_some_and(|variance| variance <= 1e-24 * expected * expected);
    if !still {
        return None;
    }
    let draws = draw(subject, seed, 2000, ROWS)?;
    let weight = draws.f64(column::WEIGHT).ok()?;
    let first = weight[0];
    let same = |&weight: &f64| (weight - first).abs() <= 1e-9 * expected.abs() + subject.tolerance;
    let other = weight.iter().find(|weight| !same(weight))?;
    let words = format!("estimates are {first:e} and {other:e} where there can be no noise");
    Some(Fact::new(CHECK.0, Reason::WrongVariance, words))
}

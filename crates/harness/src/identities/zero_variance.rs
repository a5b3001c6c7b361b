use crate::experiment::Probe;
use freepath_draws::column;
use freepath_results::Reason;
use freepath_statistics::Fact;
use freepath_statistics::check::Check;

/// The record of the check.
pub(crate) const CHECK: Check = Check {
    name: "identity_zero_variance",
    words: "A fact: where the moments that an estimator claims leave no variance, two estimates must be equal.",
    details: "Gives wrong_variance. 256 estimates, equal to 1e-9 of the mean where the claimed moments leave no variance.",
    section: "identity_zero_variance",
};

/// Estimates that are compared.
const ROWS: usize = 256;

/// Estimates differ where the claims say that they cannot.
pub(crate) fn zero_variance(variance: Option<f64>, expected: f64, probe: &Probe) -> Option<Fact> {
    let still = variance.is_some_and(|variance| variance <= 1e-24 * expected * expected);
    if !still {
        return None;
    }
    let draws = probe.draw(2000, ROWS)?;
    let weights = draws.f64(column::WEIGHT).ok()?;
    let first = weights[0];
    let same = |&weight: &f64| (weight - first).abs() <= 1e-9 * expected.abs() + probe.terms().tolerance;
    let other = weights.iter().find(|weight| !same(weight))?;
    let words = format!("estimates are {first:e} and {other:e} where there can be no noise");
    Some(Fact::new(CHECK.name, Reason::WrongVariance, words))
}

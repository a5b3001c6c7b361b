use super::unit_weight::finite;
use super::{Claim, Finding, Summary, Withdrawal, counted};
use crate::check;
use crate::evidence::Fact;
use crate::fold::{FoldId, Tallies, Weights};
use crate::judged::Judged;
use crate::tally::PowerSums;
use freepath_draws::Draws;
use freepath_results::{ClaimResult, Reason};

/// Every estimate is finite, and within its range if one is known.
pub struct Estimates {
    /// The column.
    pub column: &'static str,
    /// Its sums.
    pub weights: FoldId<Weights>,
    /// The least and greatest value.
    pub range: Option<(f64, f64)>,
    /// The most by which an estimate may be off.
    pub tolerance: f64,
}

impl Claim for Estimates {
    fn statement(&self) -> Option<ClaimResult> {
        let range = self.range.map(|(low, high)| format!(" and lies in [{low:.4e}, {high:.4e}]"));
        Some(ClaimResult::new("estimates", format!("every estimate is finite{}", range.unwrap_or_default())))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let sums = &tallies.sums(self.weights).all;
        let spoilt = counted(check::FINITE, sums.non_finite, Reason::NonFinite, "draws are NaN or infinite");
        into.facts.extend(spoilt);
        into.facts.extend(self.range.and_then(|range| out_of_range("draws", sums, range, self.tolerance)));
    }

    fn look(&self, draws: &Draws, row: usize) -> Option<Finding> {
        let weight = draws.f64(self.column).ok()?[row];
        finite(weight).or_else(|| self.outside(weight, self.range?))
    }

    fn summarize(&self, tallies: &Tallies, into: &mut Summary) {
        into.audit.non_finite += tallies.sums(self.weights).all.non_finite;
    }
}

impl Estimates {
    fn outside(&self, weight: f64, (low, high): (f64, f64)) -> Option<Finding> {
        let inside = holds(weight, (low, high), self.tolerance);
        let what = || format!("the estimate {weight:e} lies outside its range, {low:e} to {high:e}");
        (!inside).then(|| Finding { reason: Reason::OutOfSupport, what: what() })
    }
}

/// True if a number lies in a range, but for rounding and the tolerance.
fn holds(x: f64, (low, high): (f64, f64), tolerance: f64) -> bool {
    let rounding = 1e-9 * (high - low) + tolerance;
    x >= low - rounding && x <= high + rounding
}

/// The fact that finite numbers lie outside of a range.
pub(super) fn out_of_range(what: &str, sums: &PowerSums, range: (f64, f64), tolerance: f64) -> Option<Fact> {
    let (PowerSums { least, greatest, .. }, (low, high)) = (*sums, range);
    let inside = sums.n == 0 || [least, greatest].into_iter().all(|x| holds(x, range, tolerance));
    let words = || format!("{what} go from {least:e} to {greatest:e}, out of their range, {low:e} to {high:e}");
    (!inside).then(|| Fact::new(check::RANGE.name, Reason::OutOfSupport, words()))
}

use super::unit_weight::finite;
use super::{Claim, Finding, Summary, Withdrawal, counted};
use crate::check;
use crate::fold::{FoldId, Tallies, Weights};
use crate::judged::Judged;
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
        let spoilt = tallies.sums(self.weights).all.non_finite;
        into.facts.extend(counted(check::FINITE, spoilt, Reason::NonFinite, "draws are NaN or infinite"));
    }

    fn look(&self, draws: &Draws, row: usize) -> Option<Finding> {
        let weight = draws.f64(self.column).ok()?[row];
        finite(weight).or_else(|| outside(weight, self.range?))
    }

    fn summarize(&self, tallies: &Tallies, into: &mut Summary) {
        into.audit.non_finite += tallies.sums(self.weights).all.non_finite;
    }
}

fn outside(weight: f64, (low, high): (f64, f64)) -> Option<Finding> {
    let rounding = 1e-9 * (high - low);
    let inside = weight >= low - rounding && weight <= high + rounding;
    let what = || format!("the estimate {weight:e} lies outside its range, {low:e} to {high:e}");
    (!inside).then(|| Finding { reason: Reason::OutOfSupport, what: what() })
}

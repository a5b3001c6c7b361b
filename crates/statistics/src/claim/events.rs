use super::estimates::out_of_range;
use super::unit_weight::finite;
use super::{Claim, Finding, Withdrawal, counted};
use crate::check;
use crate::fold::{EventSums, FoldId, Tallies};
use crate::judged::Judged;
use freepath_draws::Draws;
use freepath_results::{ClaimResult, Reason};

/// Every weight of every event is finite, and within its range if one is known.
pub struct EventWeights {
    /// The sums of all events.
    pub sums: Vec<FoldId<EventSums>>,
    /// The least and greatest weight, one that counts as 0 among them.
    pub range: Option<(f64, f64)>,
    /// The most by which a weight may be off.
    pub tolerance: f64,
}

impl Claim for EventWeights {
    fn statement(&self) -> Option<ClaimResult> {
        let range = self.range.map(|(low, high)| format!(" and lies in [{low:.4e}, {high:.4e}]"));
        let words = format!("every weight of every event is finite{}", range.unwrap_or_default());
        Some(ClaimResult::new("finite_weights", words))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let spoilt = self.sums.iter().map(|&sums| tallies.sums(sums).non_finite).sum();
        into.facts.extend(counted(check::FINITE, spoilt, Reason::NonFinite, "weights are NaN or infinite"));
        let outside = |range| {
            let of =
                |&sums: &FoldId<EventSums>| out_of_range("weights", tallies.sums(sums), range, self.tolerance);
            self.sums.iter().find_map(of)
        };
        into.facts.extend(self.range.and_then(outside));
    }
}

/// Every weight of a row is finite: seen row by row alone.
pub struct FiniteRow {
    /// The columns of weights.
    pub columns: Vec<String>,
}

impl Claim for FiniteRow {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new("finite_rows", "every weight of a row is finite"))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[]
    }

    fn look(&self, draws: &Draws, row: usize) -> Option<Finding> {
        self.columns.iter().find_map(|column| finite(draws.f64(column).ok()?[row]))
    }
}

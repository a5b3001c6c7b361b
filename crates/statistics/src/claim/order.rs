use super::{Claim, Withdrawal};
use crate::fold::{Cells, FoldId, Lags, Tallies};
use crate::hypothesis;
use crate::judged::Judged;
use crate::tally::Scores;
use freepath_results::ClaimResult;
use std::sync::Arc;

/// Draws that are a few rows apart are independent, in ranks under a law that they follow.
pub struct Order {
    /// The rank of each cell.
    pub scores: Arc<Scores>,
    /// Products and tables of neighbours.
    pub lags: FoldId<Lags>,
    /// The column by cell.
    pub cells: FoldId<Cells>,
}

impl Claim for Order {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new("independent", "draws that are a few rows apart are independent"))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let (lags, cells) = (tallies.counts(self.lags), tallies.counts(self.cells));
        into.evidence.push(hypothesis::lag(&self.scores, lags, cells));
        into.evidence.push(hypothesis::lags(&self.scores, lags, cells));
        into.evidence.push(hypothesis::pairs(lags));
    }
}

/// Neighbouring draws are uncorrelated, whatever their law: ranks only say what is multiplied.
pub struct ObservedOrder {
    /// The rank of each cell.
    pub scores: Arc<Scores>,
    /// Products of neighbours.
    pub lags: FoldId<Lags>,
    /// The column by cell.
    pub cells: FoldId<Cells>,
}

impl Claim for ObservedOrder {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new("uncorrelated", "neighbouring draws are uncorrelated, whatever their law"))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let (lags, cells) = (tallies.counts(self.lags), tallies.counts(self.cells));
        into.evidence.push(hypothesis::lag_observed(&self.scores, lags, cells));
    }
}

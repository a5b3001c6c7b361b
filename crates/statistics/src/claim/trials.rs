use super::law::prefixed;
use super::{Claim, Withdrawal};
use crate::fold::{Cells, FoldId, Tallies};
use crate::hypothesis;
use crate::judged::Judged;
use freepath_results::{ClaimResult, Reason};

/// A column counts the trials of each draw, and they follow a law of their own: that of a rejection, geometric.
pub struct Trials {
    /// The counts by cell: one for each number from 0 on, the last for all beyond.
    pub cells: FoldId<Cells>,
    /// The probability of each number.
    pub masses: Vec<f64>,
    /// The mean.
    pub mean: f64,
    /// The most by which a probability may be off.
    pub slack: f64,
}

impl Claim for Trials {
    fn statement(&self) -> Option<ClaimResult> {
        let words = format!("the trials of a draw are geometric with mean {:.4e}", self.mean);
        Some(ClaimResult::new("trials", words))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let cells = tallies.counts(self.cells);
        let evidence = hypothesis::count_law(&cells.cells, &self.masses, self.slack, Reason::WrongLaw);
        into.evidence.push(prefixed("trials_", evidence));
    }
}

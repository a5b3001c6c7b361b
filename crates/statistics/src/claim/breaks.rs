use super::law::prefixed;
use super::{Claim, Withdrawal};
use crate::fold::{Breaks, Cells, FoldId, Tallies};
use crate::hypothesis;
use crate::judged::Judged;
use crate::tally::Flanks;
use freepath_results::{ClaimResult, Reason};
use std::sync::Arc;

/// A column follows a law close to its breaks, within the fine cells that they lie in as well.
pub struct BreaksClaim {
    /// `own_` for the law that a method has by design.
    pub prefix: &'static str,
    /// The flanks of the breaks under the law.
    pub flanks: Arc<Flanks>,
    /// The draws in them.
    pub near: FoldId<Breaks>,
    /// The column by cell.
    pub cells: FoldId<Cells>,
    /// The reason that a rejection gives.
    pub reason: Reason,
}

impl Claim for BreaksClaim {
    fn statement(&self) -> Option<ClaimResult> {
        let name = format!("{}breaks", self.prefix);
        Some(ClaimResult::new(name, "the draws close to a break, or to an end of the ray, follow the law"))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let (near, draws) = (tallies.counts(self.near), tallies.counts(self.cells).draws());
        into.evidence.push(prefixed(self.prefix, hypothesis::breaks(&self.flanks, near, draws, self.reason)));
    }
}

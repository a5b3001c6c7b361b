use super::{Claim, Summary, Withdrawal};
use crate::fold::{FoldId, Lookups, Tallies};
use crate::hypothesis::{self, Cost};
use crate::judged::Judged;
use freepath_results::ClaimResult;

/// A draw makes so many look-ups on average.
pub struct LookupsClaim {
    /// So many.
    pub cost: Cost,
    /// The look-ups that the audit saw.
    pub lookups: FoldId<Lookups>,
    /// Rows of a block.
    pub rows: usize,
}

impl Claim for LookupsClaim {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new("lookups", format!("a draw makes {:.4e} look-ups on average", self.cost.expected)))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::Lookups, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let blocks = &tallies.counts(self.lookups).blocks;
        into.evidence.push(hypothesis::lookups(blocks, self.rows, self.cost));
    }

    fn state(&self, into: &mut Summary) {
        into.lookups_expected = Some(self.cost.expected);
    }
}

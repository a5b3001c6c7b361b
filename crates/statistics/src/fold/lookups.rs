use super::{Fold, Merge};
use crate::block::{Block, Scratch};
use crate::hypothesis::BlockLookups;
use crate::tally::Audit;
use freepath_draws::MissingColumn;

/// The audit's counts of each block; nothing of draws that are made elsewhere.
pub struct Lookups;

/// Look-ups, all told and by block.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LookupCounts {
    /// All told.
    pub audit: Audit,
    /// By block.
    pub blocks: BlockLookups,
}

impl Merge for LookupCounts {
    fn merge(&mut self, other: &Self) {
        self.audit = self.audit.plus(other.audit);
        self.blocks.merge(&other.blocks);
    }
}

impl Fold for Lookups {
    type Counts = LookupCounts;
    type Sums = ();

    fn empty(&self) -> LookupCounts {
        LookupCounts::default()
    }
    fn no_sums(&self) {}
    fn observe(&self, block: &Block, _: &mut Scratch, counts: &mut LookupCounts) -> Result<(), MissingColumn> {
        if let Some(&audit) = block.audit {
            counts.audit = counts.audit.plus(audit);
            counts.blocks.observe(audit.lookups);
        }
        Ok(())
    }
}

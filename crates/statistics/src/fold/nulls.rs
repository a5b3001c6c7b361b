use super::{Fold, LookupWatch, Merge};
use crate::block::{Block, CellIndex, Scratch, is_early};
use crate::law::Law;
use crate::tally::NullTally;
use freepath_draws::MissingColumn;
use std::sync::Arc;

/// Tentative and real collisions along the ray, of the first blocks.
pub struct Nulls {
    /// The law of the real ones.
    pub law: Arc<Law>,
    /// The cells of the rows.
    pub index: CellIndex,
}

impl Merge for NullTally {
    fn merge(&mut self, other: &Self) {
        self.merge(other);
    }
}

impl LookupWatch for NullTally {
    fn look_ups(&mut self, t: &[f64], mu: &[f64], bound: &[f64]) {
        NullTally::look_ups(self, t, mu, bound);
    }
}

impl Fold for Nulls {
    type Counts = NullTally;
    type Sums = ();

    fn empty(&self) -> NullTally {
        NullTally::new(&self.law)
    }
    fn no_sums(&self) {}
    fn observe(&self, block: &Block, scratch: &mut Scratch, counts: &mut NullTally) -> Result<(), MissingColumn> {
        if block.is_early() {
            counts.draws(scratch.cells(self.index));
        }
        Ok(())
    }
    fn watch<'a>(&self, nth: u64, counts: &'a mut NullTally) -> Option<&'a mut dyn LookupWatch> {
        if is_early(nth) { Some(counts) } else { None }
    }
}

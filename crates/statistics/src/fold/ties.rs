use super::{Fold, Merge};
use crate::block::{Block, Scratch};
use crate::tally::TieTally;
use freepath_draws::MissingColumn;

/// Equal values of a column: all of them in the first blocks, among neighbours after that.
pub struct Ties {
    /// The column.
    pub column: &'static str,
}

impl Merge for TieTally {
    fn merge(&mut self, other: &Self) {
        self.merge(other.clone());
    }
}

impl Fold for Ties {
    type Counts = TieTally;
    type Sums = ();

    fn empty(&self) -> TieTally {
        TieTally::default()
    }
    fn no_sums(&self) {}
    fn observe(&self, block: &Block, _: &mut Scratch, counts: &mut TieTally) -> Result<(), MissingColumn> {
        counts.observe(block.f64(self.column)?, block.is_early());
        Ok(())
    }
}

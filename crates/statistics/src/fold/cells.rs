use super::{Fold, Merge};
use crate::block::{Block, CellIndex, Scratch};
use crate::law::Law;
use crate::tally::CellTally;
use freepath_draws::MissingColumn;
use std::sync::Arc;

/// Counts of one column in the fine cells of a law; the cell of each row is left for other folds.
pub struct Cells {
    /// The column.
    pub column: &'static str,
    /// The law whose cells they are.
    pub law: Arc<Law>,
    /// Where the cells of the rows are left.
    pub index: CellIndex,
}

impl Merge for CellTally {
    fn merge(&mut self, other: &Self) {
        self.merge(other);
    }
}

impl Fold for Cells {
    type Counts = CellTally;
    type Sums = ();

    fn empty(&self) -> CellTally {
        CellTally::new(&self.law)
    }
    fn no_sums(&self) {}
    fn observe(&self, block: &Block, scratch: &mut Scratch, counts: &mut CellTally) -> Result<(), MissingColumn> {
        counts.observe(&self.law, block.f64(self.column)?, scratch.cells_mut(self.index));
        Ok(())
    }
}

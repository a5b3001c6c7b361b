use super::{Fold, Merge};
use crate::block::{Block, CellIndex, Scratch};
use crate::tally::{AuxiliaryTally, Scores};
use freepath_draws::MissingColumn;
use std::sync::Arc;

/// A number in [0, 1) that comes with each draw, by groups of another column's ranks.
pub struct Auxiliary {
    /// The column of those numbers.
    pub column: &'static str,
    /// The rank of each cell of the other column.
    pub scores: Arc<Scores>,
    /// The cells of the rows of the other column.
    pub index: CellIndex,
}

impl Merge for AuxiliaryTally {
    fn merge(&mut self, other: &Self) {
        self.merge(other);
    }
}

impl Fold for Auxiliary {
    type Counts = AuxiliaryTally;
    type Sums = ();

    fn empty(&self) -> AuxiliaryTally {
        AuxiliaryTally::default()
    }
    fn no_sums(&self) {}
    fn observe(
        &self,
        block: &Block,
        scratch: &mut Scratch,
        counts: &mut AuxiliaryTally,
    ) -> Result<(), MissingColumn> {
        counts.observe(&self.scores, block.f64(self.column)?, scratch.cells(self.index));
        Ok(())
    }
}

use super::{Fold, Merge};
use crate::block::{Block, CellIndex, Scratch};
use crate::tally::{FlankTally, Flanks};
use freepath_draws::MissingColumn;
use std::sync::Arc;

/// Draws near the breaks of a law.
pub struct Breaks {
    /// The column.
    pub column: &'static str,
    /// Where they are counted.
    pub flanks: Arc<Flanks>,
    /// The cells of the rows.
    pub index: CellIndex,
}

impl Merge for FlankTally {
    fn merge(&mut self, other: &Self) {
        self.merge(other);
    }
}

impl Fold for Breaks {
    type Counts = FlankTally;
    type Sums = ();

    fn empty(&self) -> FlankTally {
        FlankTally::default()
    }
    fn no_sums(&self) {}
    fn observe(&self, block: &Block, scratch: &mut Scratch, counts: &mut FlankTally) -> Result<(), MissingColumn> {
        counts.observe(&self.flanks, block.f64(self.column)?, scratch.cells(self.index));
        Ok(())
    }
}

use super::{Fold, Merge};
use crate::block::{Block, CellIndex, Scratch};
use crate::tally::{LagTally, Scores};
use freepath_draws::MissingColumn;
use std::sync::Arc;

/// Products and tables of draws that are a few rows apart, in ranks.
pub struct Lags {
    /// The rank of each cell.
    pub scores: Arc<Scores>,
    /// The cells of the rows.
    pub index: CellIndex,
}

impl Merge for LagTally {
    fn merge(&mut self, other: &Self) {
        self.merge(other);
    }
}

impl Fold for Lags {
    type Counts = LagTally;
    type Sums = ();

    fn empty(&self) -> LagTally {
        LagTally::default()
    }
    fn no_sums(&self) {}
    fn observe(&self, _: &Block, scratch: &mut Scratch, counts: &mut LagTally) -> Result<(), MissingColumn> {
        counts.observe(&self.scores, scratch.cells(self.index));
        Ok(())
    }
}

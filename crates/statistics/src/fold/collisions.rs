use super::{Fold, Merge};
use crate::block::{Block, CellIndex, Scratch};
use crate::law::Law;
use crate::tally::CountTally;
use freepath_draws::MissingColumn;
use std::sync::Arc;

/// The other axis of a histogram of the numbers of collisions.
#[derive(Clone)]
pub enum Histogram {
    /// Nothing else.
    Marginal,
    /// Groups of the cells of another column.
    Joint(Arc<Law>, CellIndex),
}

/// Counts of an integer column.
pub struct Collisions {
    /// The column.
    pub column: &'static str,
    /// By what else.
    pub histogram: Histogram,
}

impl Merge for CountTally {
    fn merge(&mut self, other: &Self) {
        self.merge(other);
    }
}

impl Fold for Collisions {
    type Counts = CountTally;
    type Sums = ();

    fn empty(&self) -> CountTally {
        match &self.histogram {
            Histogram::Marginal => CountTally::marginal(),
            Histogram::Joint(law, _) => CountTally::joint(law),
        }
    }
    fn no_sums(&self) {}
    fn observe(&self, block: &Block, scratch: &mut Scratch, counts: &mut CountTally) -> Result<(), MissingColumn> {
        let cells = match &self.histogram {
            Histogram::Marginal => &[],
            Histogram::Joint(_, index) => scratch.cells(*index),
        };
        counts.observe(block.u32(self.column)?, cells);
        Ok(())
    }
}

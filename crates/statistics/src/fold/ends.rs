use super::{Fold, Merge};
use crate::block::{Block, Scratch};
use crate::tally::Extremes;
use freepath_draws::MissingColumn;

/// The values of a column that are nearest to either end of [0, length].
pub struct Ends {
    /// The column.
    pub column: &'static str,
    /// The far end.
    pub length: f64,
}

impl Merge for Box<Extremes> {
    fn merge(&mut self, other: &Self) {
        Extremes::merge(self, other);
    }
}

impl Fold for Ends {
    type Counts = Box<Extremes>;
    type Sums = ();

    fn empty(&self) -> Box<Extremes> {
        Box::new(Extremes::new(self.length))
    }
    fn no_sums(&self) {}
    fn observe(&self, block: &Block, _: &mut Scratch, counts: &mut Box<Extremes>) -> Result<(), MissingColumn> {
        counts.observe(block.f64(self.column)?);
        Ok(())
    }
}

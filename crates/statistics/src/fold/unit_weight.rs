use super::{Fold, Merge};
use crate::block::{Block, Scratch};
use freepath_draws::MissingColumn;

/// The number of rows that have a weight other than 1.
pub struct UnitWeight {
    /// The column of weights.
    pub column: &'static str,
}

impl Merge for u64 {
    fn merge(&mut self, other: &Self) {
        *self += other;
    }
}

impl Fold for UnitWeight {
    type Counts = u64;
    type Sums = ();

    fn empty(&self) -> u64 {
        0
    }
    fn no_sums(&self) {}
    fn observe(&self, block: &Block, _: &mut Scratch, counts: &mut u64) -> Result<(), MissingColumn> {
        let other = |weight: &&f64| weight.to_bits() != 1f64.to_bits();
        *counts += block.f64(self.column)?.iter().filter(other).count() as u64;
        Ok(())
    }
}

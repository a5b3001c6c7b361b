use super::{Fold, Ordered};
use crate::block::{Block, Scratch};
use crate::sequence::{Bets, Capitals};
use freepath_draws::MissingColumn;

/// The gain of bets on the rows of a column.
pub struct CapitalSums {
    /// The column.
    pub column: &'static str,
    /// The bets.
    pub bets: Bets,
}

impl Ordered for Capitals {
    type Part = Self;
    fn fold(&mut self, part: &Self) {
        self.merge(part);
    }
    fn extend(&mut self, later: &Self) {
        self.merge(later);
    }
}

impl Fold for CapitalSums {
    type Counts = ();
    type Sums = Capitals;

    fn empty(&self) {}
    fn no_sums(&self) -> Capitals {
        Capitals::default()
    }
    fn observe(&self, block: &Block, _: &mut Scratch, (): &mut ()) -> Result<Capitals, MissingColumn> {
        Ok(self.bets.on(block.f64(self.column)?))
    }
}

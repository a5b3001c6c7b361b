use super::{Fold, Merge};
use crate::block::{Block, CellIndex, Scratch};
use crate::law::Law;
use crate::tally::CellTally;
use freepath_draws::MissingColumn;
use std::sync::Arc;

/// The numbers of the rows that follow a law.
#[derive(Clone)]
pub enum Values {
    /// Those of a column.
    Column(&'static str),
    /// A rank of columns, row by row: its law is uniform wherever theirs is continuous.
    Rank(Rank),
}

/// A function of the columns of a row.
pub type RankOf = Arc<dyn Fn(&[f64]) -> f64 + Send + Sync>;

/// A number made of the columns of a row.
#[derive(Clone)]
pub struct Rank {
    /// The columns.
    pub columns: &'static [&'static str],
    /// The function of them, in their order.
    pub of: RankOf,
}

/// Counts of numbers in the fine cells of a law; the cell of each row is left for other folds.
pub struct Cells {
    /// The numbers.
    pub values: Values,
    /// The law whose cells they are.
    pub law: Arc<Law>,
    /// The place where the cells of the rows are left.
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
        let index = scratch.cells_mut(self.index);
        match &self.values {
            Values::Column(column) => counts.observe(&self.law, block.f64(column)?, index),
            Values::Rank(rank) => counts.observe(&self.law, &rank.column(block)?, index),
        }
        Ok(())
    }
}

impl Rank {
    fn column(&self, block: &Block) -> Result<Vec<f64>, MissingColumn> {
        let mut ranks = Vec::with_capacity(block.draws.rows());
        block.for_each_row(self.columns, |row| ranks.push((self.of)(row)))?;
        Ok(ranks)
    }
}

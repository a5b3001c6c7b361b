use super::{Fold, Ordered};
use crate::block::{Block, CellIndex, Scratch};
use crate::tally::{Bins, WeighedSums};
use freepath_draws::MissingColumn;
use std::borrow::Cow;
use std::sync::Arc;

/// Sums of w, w^2 and w^3 of some columns of weights, in bins of the distance.
pub struct Weighed {
    /// The columns of weights.
    pub columns: Vec<Cow<'static, str>>,
    /// The column of distances.
    pub distance: &'static str,
    /// The bins.
    pub bins: Arc<Bins>,
    /// The place where the fine cells of the rows are left.
    pub index: CellIndex,
}

impl Ordered for WeighedSums {
    type Part = Self;
    fn fold(&mut self, part: &Self) {
        self.merge(part);
    }
    fn extend(&mut self, later: &Self) {
        self.merge(later);
    }
}

impl Fold for Weighed {
    type Counts = ();
    type Sums = WeighedSums;

    fn empty(&self) {}
    fn no_sums(&self) -> WeighedSums {
        WeighedSums::new(&self.bins, self.columns.len())
    }
    fn observe(&self, block: &Block, scratch: &mut Scratch, (): &mut ()) -> Result<WeighedSums, MissingColumn> {
        let columns: Vec<&[f64]> =
            self.columns.iter().map(|column| block.f64(column)).collect::<Result<_, _>>()?;
        let mut sums = self.no_sums();
        sums.observe(&self.bins, block.f64(self.distance)?, &columns, scratch.cells_mut(self.index));
        Ok(sums)
    }
}

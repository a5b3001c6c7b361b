use super::event::{Event, mask};
use super::{Fold, Ordered};
use crate::block::{Block, Scratch};
use crate::sequence::{Portfolio, Wealth};
use freepath_draws::MissingColumn;
use std::borrow::Cow;

/// The capital of a portfolio of bets on the rows of a column.
pub struct WealthSums {
    /// The column.
    pub column: Cow<'static, str>,
    /// The event whose rows count, by a column of distances, all others being 0; every row if there is none.
    pub event: Option<(&'static str, Event)>,
    /// The bets.
    pub portfolio: Portfolio,
}

impl Ordered for Wealth {
    type Part = Self;
    fn fold(&mut self, part: &Self) {
        self.merge(part);
    }
    fn extend(&mut self, later: &Self) {
        self.merge(later);
    }
}

impl Fold for WealthSums {
    type Counts = ();
    type Sums = Wealth;

    fn empty(&self) {}
    fn no_sums(&self) -> Wealth {
        Wealth::default()
    }
    fn observe(&self, block: &Block, scratch: &mut Scratch, (): &mut ()) -> Result<Wealth, MissingColumn> {
        let column = block.f64(&self.column)?;
        let Some((distance, event)) = self.event else { return Ok(self.portfolio.on(column)) };
        mask(scratch, column, block.f64(distance)?, event);
        Ok(self.portfolio.on(&scratch.masked))
    }
}

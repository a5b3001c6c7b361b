use super::event::{Event, mask};
use super::{Fold, Ordered};
use crate::block::{Block, CellIndex, Scratch};
use crate::law::Law;
use crate::tally::{BatchSums, CellTally, SHARES};
use freepath_draws::MissingColumn;
use std::borrow::Cow;

/// Sums over batches of neighbouring rows: of a column, or of the shares of a law's cells.
pub struct Batched {
    numbers: Numbers,
    group: Option<u64>,
}

enum Numbers {
    /// Of a column.
    Column(Cow<'static, str>),
    /// Of a column where an event happens, by a column of distances, 0 elsewhere.
    Event(Cow<'static, str>, &'static str, Event),
    /// Of each group of cells, and of the atom.
    Shares(CellIndex, Vec<u32>),
}

/// The numbers of one block.
pub enum BatchPart {
    /// One of each row.
    Numbers(Vec<f64>),
    /// The group of each row.
    Slots(Vec<u32>),
}

impl Batched {
    /// Of a column.
    #[must_use]
    pub fn column(column: impl Into<Cow<'static, str>>) -> Self {
        Self::of(Numbers::Column(column.into()))
    }

    /// Of a column where an event happens, 0 elsewhere.
    #[must_use]
    pub fn event(column: Cow<'static, str>, distance: &'static str, event: Event) -> Self {
        Self::of(Numbers::Event(column, distance, event))
    }

    /// Of the shares of a law's 16 groups of cells and of its atom; the fold of the cells stands before.
    #[must_use]
    pub fn shares(law: &Law, index: CellIndex) -> Self {
        let bounds = law.groups(SHARES).bounds;
        let slot = |(group, w): (usize, &[usize])| std::iter::repeat_n(group as u32, w[1] - w[0]);
        let mut slots: Vec<u32> = bounds.windows(2).enumerate().flat_map(slot).collect();
        slots.push((bounds.len() - 1) as u32); // the atom
        Self::of(Numbers::Shares(index, slots))
    }

    /// The same over groups of rows that are independent of one another, if rows come in such.
    #[must_use]
    pub fn grouped(self, group: Option<u64>) -> Self {
        Self { group, ..self }
    }

    fn of(numbers: Numbers) -> Self {
        Self { numbers, group: None }
    }
}

impl Ordered for BatchSums {
    type Part = BatchPart;
    fn fold(&mut self, part: &BatchPart) {
        match part {
            BatchPart::Numbers(column) => self.observe(column),
            BatchPart::Slots(slots) => self.observe_slots(slots),
        }
    }
    fn extend(&mut self, _: &Self) {} // nothing grows without independent draws
}

impl Fold for Batched {
    type Counts = ();
    type Sums = BatchSums;

    fn empty(&self) {}
    fn no_sums(&self) -> BatchSums {
        let width = match &self.numbers {
            Numbers::Column(_) | Numbers::Event(..) => 1,
            Numbers::Shares(..) => SHARES + 1,
        };
        BatchSums::grouped(width, self.group)
    }
    fn observe(&self, block: &Block, scratch: &mut Scratch, (): &mut ()) -> Result<BatchPart, MissingColumn> {
        match &self.numbers {
            Numbers::Column(column) => Ok(BatchPart::Numbers(block.f64(column)?.to_vec())),
            Numbers::Event(column, distance, event) => {
                mask(scratch, block.f64(column)?, block.f64(distance)?, *event);
                Ok(BatchPart::Numbers(scratch.masked.clone()))
            }
            Numbers::Shares(index, slots) => {
                let atom = slots.len() - 1;
                let place = |&cell: &u32| if CellTally::is_escape(cell) { atom } else { cell as usize };
                let of = |cell| *slots.get(place(cell)).unwrap_or(&u32::MAX); // out of the support
                Ok(BatchPart::Slots(scratch.cells(*index).iter().map(of).collect()))
            }
        }
    }
}

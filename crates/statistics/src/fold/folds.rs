use super::erased::{AnyFold, Part, State, own};
use super::strays::ProbableEscape;
use super::{Fold, LookupWatch};
use crate::block::{Block, CellIndex, Scratch};
use freepath_draws::MissingColumn;
use std::marker::PhantomData;
use std::sync::Arc;

/// A fold in a list, and what it left in [`Tallies`].
pub struct FoldId<F>(usize, PhantomData<fn() -> F>);

impl<F> Clone for FoldId<F> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<F> Copy for FoldId<F> {}

/// The folds that the claims on one subject read.
#[derive(Clone, Default)]
pub struct Folds {
    list: Vec<Arc<dyn AnyFold>>,
    indices: usize,
}

/// The counts of one worker.
pub struct Counts(Vec<Box<dyn State>>);

/// The parts that one block leaves: the floats of every fold.
pub struct Parts(Vec<Part>);

/// The tallies of every fold over a range of blocks.
#[derive(Default)]
pub struct Tallies {
    counts: Vec<Box<dyn State>>,
    sums: Vec<Box<dyn State>>,
    /// Draws taken.
    pub draws: u64,
    /// The tallies of draws made beside these, such as of a ray in two parts.
    pub beside: Vec<Tallies>,
    /// The stand-in that was counted as an escape, though nothing says so.
    pub assumed: Option<ProbableEscape>,
}

impl Folds {
    /// Adds a fold. A fold that reads the cells of another stands behind it.
    pub fn add<F: Fold>(&mut self, fold: F) -> FoldId<F> {
        self.list.push(Arc::new(fold));
        FoldId(self.list.len() - 1, PhantomData)
    }

    /// A place for the cells of one column.
    pub fn cell_index(&mut self) -> CellIndex {
        self.indices += 1;
        CellIndex(self.indices - 1)
    }

    /// The same list with another fold of the same type at `id`: what it tallies goes on where the old one stopped.
    #[must_use]
    pub fn replaced<F: Fold>(&self, id: FoldId<F>, fold: F) -> Self {
        let mut folds = self.clone();
        folds.list[id.0] = Arc::new(fold);
        folds
    }

    /// True if a fold needs the first block of a range tallied before all others.
    #[must_use]
    pub fn wait_for_first(&self) -> bool {
        self.list.iter().any(|fold| fold.waits_for_first())
    }

    /// The list that tallies the blocks after the first of their range.
    ///
    /// # Errors
    /// If the block lacks a column that a fold reads.
    pub fn after_first(&self, first: &Block) -> Result<Self, MissingColumn> {
        let mut folds = self.clone();
        for fold in &mut folds.list {
            if let Some(later) = fold.after_first(first)? {
                *fold = later;
            }
        }
        Ok(folds)
    }

    /// Counts before the first block.
    #[must_use]
    pub fn empty(&self) -> Counts {
        Counts(self.list.iter().map(|fold| fold.empty()).collect())
    }

    /// The watch on the look-ups of the block at place `nth`: that of the first fold that asks.
    pub fn watch<'a>(&self, nth: u64, counts: &'a mut Counts) -> Option<&'a mut dyn LookupWatch> {
        let mut all = self.list.iter().zip(&mut counts.0);
        all.find_map(|(fold, counts)| fold.watch(nth, &mut **counts))
    }

    /// Counts the rows of a block, and sums them up.
    ///
    /// # Errors
    /// If the block lacks a column that a fold reads.
    pub fn observe(
        &self,
        block: &Block,
        scratch: &mut Scratch,
        counts: &mut Counts,
    ) -> Result<Parts, MissingColumn> {
        let all = self.list.iter().zip(&mut counts.0);
        all.map(|(fold, counts)| fold.observe(block, scratch, &mut **counts)).collect::<Result<_, _>>().map(Parts)
    }

    /// Takes in what another worker counted.
    pub fn merge(&self, counts: &mut Counts, other: &Counts) {
        self.merge_states(&mut counts.0, &other.0);
    }

    /// Tallies before the first block.
    #[must_use]
    pub fn tallies(&self) -> Tallies {
        let sums = self.list.iter().map(|fold| fold.no_sums()).collect();
        Tallies { counts: self.empty().0, sums, ..Tallies::default() }
    }

    /// Takes in the floats of the next block, in block order.
    pub fn fold(&self, tallies: &mut Tallies, parts: &Parts) {
        for ((fold, sums), part) in self.list.iter().zip(&mut tallies.sums).zip(&parts.0) {
            fold.fold(&mut **sums, &**part);
        }
    }

    /// Takes in all that a worker counted.
    pub fn count(&self, tallies: &mut Tallies, counts: &Counts) {
        self.merge_states(&mut tallies.counts, &counts.0);
    }

    /// Takes in a later range of blocks.
    pub fn extend(&self, tallies: &mut Tallies, later: &Tallies) {
        self.merge_states(&mut tallies.counts, &later.counts);
        for ((fold, sums), later) in self.list.iter().zip(&mut tallies.sums).zip(&later.sums) {
            fold.extend(&mut **sums, &**later);
        }
        tallies.draws += later.draws;
    }

    fn merge_states(&self, all: &mut [Box<dyn State>], more: &[Box<dyn State>]) {
        for ((fold, all), more) in self.list.iter().zip(all).zip(more) {
            fold.merge(&mut **all, &**more);
        }
    }
}

impl Tallies {
    /// The integers of a fold.
    #[must_use]
    pub fn counts<F: Fold>(&self, id: FoldId<F>) -> &F::Counts {
        own(self.counts[id.0].as_any())
    }

    /// The floats of a fold.
    #[must_use]
    pub fn sums<F: Fold>(&self, id: FoldId<F>) -> &F::Sums {
        own(self.sums[id.0].as_any())
    }
}

impl Clone for Tallies {
    fn clone(&self) -> Self {
        let copy = |states: &[Box<dyn State>]| states.iter().map(|state| (**state).copy()).collect();
        let Self { draws, assumed, .. } = *self;
        Self { counts: copy(&self.counts), sums: copy(&self.sums), draws, beside: self.beside.clone(), assumed }
    }
}

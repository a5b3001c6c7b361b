//! Folds: what is tallied over blocks. A claim reads folds, and several claims may read the same one, so that a cell is
//! located once for each draw.
//!
//! Integers merge in any order, so each worker keeps its own counts. Floats do not: each block leaves a part, and parts are
//! added in block order, whichever worker made them.

use crate::block::{Block, Scratch};
use freepath_draws::MissingColumn;

mod auxiliary;
mod batched;
mod capitals;
mod cells;
mod collisions;
mod copies;
mod ends;
mod erased;
mod event;
mod first_rows;
mod flanks;
mod folds;
mod lags;
mod lookups;
mod monotone;
mod nulls;
mod places;
mod ranked;
mod strays;
mod ties;
mod unit_weight;
mod wealth;
mod weighed;
mod weight;
mod weight_identity;

pub use auxiliary::Auxiliary;
pub use batched::{BatchPart, Batched};
pub use capitals::CapitalSums;
pub use cells::{Cells, Rank, RankOf, Values};
pub use collisions::{Collisions, Histogram};
pub use copies::{Copies, Fingerprint};
pub use ends::Ends;
pub use event::{Event, EventSums};
pub use first_rows::{FirstRows, RowWords};
pub use flanks::Breaks;
pub use folds::{Counts, FoldId, Folds, Parts, Tallies};
pub use lags::Lags;
pub use lookups::{LookupCounts, Lookups};
pub use monotone::{Monotone, Steps};
pub use nulls::Nulls;
pub use places::{Inside, PlaceCounts, Places};
pub use ranked::RankedColumn;
pub use strays::{ProbableEscape, Repeated, Sentinel, Short, StrayCounts, Strays};
pub use ties::Ties;
pub use unit_weight::UnitWeight;
pub use wealth::WealthSums;
pub use weighed::Weighed;
pub use weight::{WeightPart, WeightSums, Weights};
pub use weight_identity::{WeighedRows, WeightIdentity, WeightsOf};

/// Counts that merge in any order.
pub trait Merge {
    /// Takes in what another worker, or later blocks, counted.
    fn merge(&mut self, other: &Self);
}

/// Float sums, which are added in block order.
pub trait Ordered {
    /// The part that one block leaves.
    type Part: Send + 'static;
    /// Takes in the next block.
    fn fold(&mut self, part: &Self::Part);
    /// Takes in a later range of blocks.
    fn extend(&mut self, later: &Self);
}

/// Told of look-ups while a block is drawn: where, what was found, and the majorant that held there.
pub trait LookupWatch {
    /// Look-ups of one tile: three slices of one length.
    fn look_ups(&mut self, t: &[f64], mu: &[f64], bound: &[f64]);
}

/// A tally over blocks. It knows columns, and no subject.
pub trait Fold: Send + Sync + 'static {
    /// Integers: one for each worker.
    type Counts: Merge + Clone + Send + Sync + 'static;
    /// Floats: one for a range of blocks.
    type Sums: Ordered + Clone + Send + Sync + 'static;

    /// Counts before the first block.
    fn empty(&self) -> Self::Counts;

    /// Sums before the first block.
    fn no_sums(&self) -> Self::Sums;

    /// Counts the rows of `block`, and sums them up.
    ///
    /// # Errors
    /// If the block lacks a column that the fold reads.
    fn observe(
        &self,
        block: &Block,
        scratch: &mut Scratch,
        counts: &mut Self::Counts,
    ) -> Result<<Self::Sums as Ordered>::Part, MissingColumn>;

    /// True if the first block of a range must be tallied before all others. Provided: it need not.
    fn waits_for_first(&self) -> bool {
        false
    }

    /// The fold that tallies the blocks after the first of their range. Provided: the same.
    ///
    /// # Errors
    /// If the block lacks a column that the fold reads.
    fn after_first(&self, _first: &Block) -> Result<Option<Self>, MissingColumn>
    where
        Self: Sized,
    {
        Ok(None)
    }

    /// The watch on the look-ups of the block at place `nth` while it is drawn. Provided: none.
    fn watch<'a>(&self, _nth: u64, _counts: &'a mut Self::Counts) -> Option<&'a mut dyn LookupWatch> {
        None
    }
}

impl Merge for () {
    fn merge(&mut self, (): &Self) {}
}

impl Ordered for () {
    type Part = ();
    fn fold(&mut self, (): &()) {}
    fn extend(&mut self, (): &Self) {}
}

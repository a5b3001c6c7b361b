//! Rows in their order, by one integer score a row, so that every sum is exact.
//!
//! Two numbers are followed: the score of a row, its rank in 12 bits, and how far that lies from the median rank. Neither is ever
//! standardised by the law that is claimed, so that a wrong law is not called dependent.

mod circular;
mod dyadic;
mod edges;
mod groups;
mod kept;
mod moments;
mod prefixes;

pub use circular::{Circular, Correlations};
pub use dyadic::{DyadicBatches, DyadicSums};
pub use edges::{EDGES_FROM, Edges};
pub use groups::RankGroups;
pub use kept::{Kept, Scored};
pub use moments::ScoreMoments;
pub use prefixes::{Escaped, Prefix};

use dyadic::BlockBatches;
use prefixes::early;

/// Most rows that are kept: tests of order read the greatest power of two of them.
pub const MOST_ROWS: u64 = 1 << 17;

/// The names of the two numbers that are followed.
pub const MEASURES: [&str; 2] = ["by rank", "by distance from the median rank"];

/// Fewest rows in which order is looked for.
const FEWEST_ROWS: usize = 1 << 11;

/// The order of the rows of a stage: its first rows, and sums over all of them.
#[derive(Clone, Debug)]
pub struct Sequence {
    /// The first rows.
    pub kept: Kept,
    /// Of scores, and of their distances from the median rank, over all rows.
    pub moments: [ScoreMoments; 2],
    /// Sums over batches of neighbours, likewise.
    pub batches: [DyadicBatches; 2],
    /// Sums over the first 256, 512, .. rows.
    pub prefixes: Vec<Prefix>,
    /// Rows that escape.
    pub escapes: u64,
    /// Most rows that are kept.
    limit: usize,
}

/// The same of one block.
#[derive(Debug)]
pub struct SequencePart {
    kept: Option<Kept>,
    moments: [ScoreMoments; 2],
    batches: [BlockBatches; 2],
    early: Vec<Prefix>,
    escapes: u64,
}

/// The place of a block among those of its stage, and the rows of it that are to be kept.
pub struct BlockRows<'a> {
    /// Its place.
    pub nth: u64,
    /// The score of each row.
    pub scores: &'a [i16],
    /// The rows that escape.
    pub escaped: Escaped<'a>,
    /// Its rows, if they are among the first.
    pub kept: Option<Kept>,
}

impl SequencePart {
    /// The part of a block.
    #[must_use]
    pub fn of(rows: BlockRows) -> Self {
        let BlockRows { nth, scores, escaped, kept } = rows;
        let early = if nth == 0 { early(scores, escaped) } else { Vec::new() };
        let moments = ScoreMoments::of_both(scores);
        let escapes = escaped.count(0..scores.len());
        Self { kept, moments, batches: BlockBatches::of_both(scores), early, escapes }
    }
}

impl Sequence {
    /// Before the first block: an empty list of rows to keep, and how many.
    #[must_use]
    pub fn new(kept: Kept, limit: u64) -> Self {
        let (moments, batches) = <([ScoreMoments; 2], [DyadicBatches; 2])>::default();
        let limit = if limit < MOST_ROWS { limit } else { MOST_ROWS };
        Self { kept, moments, batches, prefixes: Vec::new(), escapes: 0, limit: limit as usize }
    }

    /// Takes in the next block.
    pub fn fold(&mut self, part: &SequencePart) {
        if let Some(kept) = &part.kept {
            self.kept.extend(kept, self.limit);
        }
        let rows = part.moments[0].rows;
        self.prefixes.extend(&part.early);
        self.escapes += part.escapes;
        for i in 0..2 {
            self.moments[i].add(&part.moments[i]);
            self.batches[i].fold(&part.batches[i], part.moments[i].sum, rows);
        }
        let seen = Prefix::new(self.moments[0].rows, self.moments.map(|of| of.sum), self.escapes);
        let last = self.prefixes.last().map_or(0, |prefix| prefix.rows);
        if seen.rows > last && seen.is_listed() {
            self.prefixes.push(seen);
        }
    }

    /// Rows of the stage.
    #[must_use]
    pub fn rows(&self) -> u64 {
        self.moments[0].rows
    }

    /// The first rows in which order is looked for, a power of two of them, by score and event; none if there are too few.
    #[must_use]
    pub fn first(&self) -> Option<Scored> {
        let rows = self.kept.rows();
        let n = if rows > 0 { 1 << rows.ilog2() } else { 0 };
        (n >= FEWEST_ROWS).then(|| self.kept.scored(n))
    }
}

/// Distances from the median rank.
fn distances(scores: &[i16]) -> Vec<i16> {
    scores.iter().map(|score| score.abs()).collect()
}

#[cfg(test)]
mod tests;

use super::{Fold, Merge, Ordered};
use crate::block::{Block, CellIndex, Scratch};
use crate::tally::{BlockRows, Escaped, Kept, LagTally, Scores, Sequence, SequencePart};
use freepath_draws::MissingColumn;
use std::sync::Arc;

/// Products and tables of draws that are a few rows apart, and the order of all rows, in ranks under a law.
pub struct Lags {
    /// The rank of each cell.
    pub scores: Arc<Scores>,
    /// The cells of the rows.
    pub index: CellIndex,
    /// Rows that are kept.
    pub rows: u64,
}

impl Merge for LagTally {
    fn merge(&mut self, other: &Self) {
        self.merge(other);
    }
}

impl Ordered for Sequence {
    type Part = SequencePart;

    fn fold(&mut self, part: &SequencePart) {
        self.fold(part);
    }
    /// The order of a stage is that of its own draws: growth does not change it.
    fn extend(&mut self, _: &Self) {}
}

impl Fold for Lags {
    type Counts = LagTally;
    type Sums = Sequence;

    fn empty(&self) -> LagTally {
        LagTally::default()
    }
    fn no_sums(&self) -> Sequence {
        Sequence::new(Kept::Scores(Vec::new(), Vec::new()), self.rows)
    }
    fn observe(
        &self,
        block: &Block,
        scratch: &mut Scratch,
        counts: &mut LagTally,
    ) -> Result<SequencePart, MissingColumn> {
        let cells = scratch.cells(self.index);
        counts.observe(&self.scores, cells);
        let (scores, escaped) = (counts.last_scores(), Escaped::Cells(cells));
        let kept = (block.first_row() < self.rows).then(|| Kept::scored_rows(scores, escaped));
        Ok(SequencePart::of(BlockRows { nth: block.nth, scores, escaped, kept }))
    }
}

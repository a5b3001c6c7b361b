use super::Fold;
use crate::block::{Block, Scratch};
use crate::tally::{BlockRows, Edges, Escaped, Kept, Sequence, SequencePart};
use freepath_draws::MissingColumn;
use std::borrow::Cow;
use std::sync::Arc;

/// The order of the rows of a column whose law is not known, in ranks among its first rows.
pub struct RankedColumn {
    column: Cow<'static, str>,
    /// Infinite ones are escapes.
    escapes: bool,
    /// Rows that are kept.
    rows: u64,
    /// The bins of the stage; none before its first block is there, which makes them.
    edges: Option<Arc<Edges>>,
}

impl RankedColumn {
    /// A column, of which so many rows are kept; infinite ones are escapes, if there are any.
    #[must_use]
    pub fn new(column: Cow<'static, str>, escapes: bool, rows: u64) -> Self {
        Self { column, escapes, rows, edges: None }
    }
}

impl Fold for RankedColumn {
    type Counts = ();
    type Sums = Sequence;

    fn empty(&self) {}
    fn no_sums(&self) -> Sequence {
        Sequence::new(Kept::Values { values: Vec::new(), escapes: self.escapes }, self.rows)
    }
    fn observe(&self, block: &Block, scratch: &mut Scratch, (): &mut ()) -> Result<SequencePart, MissingColumn> {
        let values = block.f64(&self.column)?;
        let edges = self.edges.clone().unwrap_or_else(|| Arc::new(Edges::new(values)));
        edges.score(values, &mut scratch.scores);
        let escaped = if self.escapes { Escaped::Distances(values) } else { Escaped::Never };
        let kept = || Kept::Values { values: values.to_vec(), escapes: self.escapes };
        let kept = (block.first_row() < self.rows).then(kept);
        Ok(SequencePart::of(BlockRows { nth: block.nth, scores: &scratch.scores, escaped, kept }))
    }

    fn waits_for_first(&self) -> bool {
        true
    }
    fn after_first(&self, first: &Block) -> Result<Option<Self>, MissingColumn> {
        let edges = Some(Arc::new(Edges::new(first.f64(&self.column)?)));
        Ok(Some(Self { column: self.column.clone(), edges, ..*self }))
    }
}

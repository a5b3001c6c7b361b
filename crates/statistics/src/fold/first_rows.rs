use super::copies::canonical;
use super::{Fold, Ordered};
use crate::block::{Block, Scratch};
use freepath_draws::MissingColumn;
use freepath_draws::random::split_mix;
use std::borrow::Cow;

/// The first rows of a range, as one word each.
pub struct FirstRows {
    /// The columns of a row.
    pub columns: Vec<Cow<'static, str>>,
    /// Rows that are kept.
    pub rows: usize,
}

/// Words of the first rows: equal rows have equal words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RowWords {
    /// One for each row.
    pub words: Vec<u64>,
    most: usize,
}

impl RowWords {
    fn take(&mut self, more: &[u64]) {
        let room = self.most - self.words.len();
        self.words.extend(more.iter().take(room));
    }
}

impl Ordered for RowWords {
    type Part = Vec<u64>;
    fn fold(&mut self, part: &Vec<u64>) {
        self.take(part);
    }
    fn extend(&mut self, later: &Self) {
        self.take(&later.words);
    }
}

impl Fold for FirstRows {
    type Counts = ();
    type Sums = RowWords;

    fn empty(&self) {}
    fn no_sums(&self) -> RowWords {
        RowWords { words: Vec::new(), most: self.rows }
    }
    fn observe(&self, block: &Block, _: &mut Scratch, (): &mut ()) -> Result<Vec<u64>, MissingColumn> {
        let wanted = block.first_row() < self.rows as u64;
        let mut words = vec![0; if wanted { block.draws.rows() } else { 0 }];
        for name in &self.columns {
            let column = block.f64(name)?;
            words.iter_mut().zip(column).for_each(|(word, &x)| *word = split_mix(*word ^ canonical(x)));
        }
        Ok(words)
    }
}

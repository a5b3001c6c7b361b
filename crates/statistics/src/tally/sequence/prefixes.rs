use crate::tally::cells::ESCAPE;
use std::ops::Range;

/// Rows of the shortest prefix.
const SHORTEST: u64 = 256;

/// Sums over the first rows of a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Prefix {
    /// Rows.
    pub rows: u64,
    /// Of scores, and of their distances from the median rank.
    pub sums: [i64; 2],
    /// Rows that escape.
    pub escapes: u64,
}

impl Prefix {
    pub(super) fn new(rows: u64, sums: [i64; 2], escapes: u64) -> Self {
        Self { rows, sums, escapes }
    }

    /// True if the rows are 256, 512, ..
    pub(super) fn is_listed(&self) -> bool {
        self.rows >= SHORTEST && self.rows.is_power_of_two()
    }
}

/// The rows of a block that escape.
#[derive(Clone, Copy)]
pub enum Escaped<'a> {
    /// Of a column that has none.
    Never,
    /// As the fine cells of the rows tell.
    Cells(&'a [u32]),
    /// As distances tell.
    Distances(&'a [f64]),
}

impl Escaped<'_> {
    /// True if row `i` escapes.
    pub(super) fn holds(self, i: usize) -> bool {
        match self {
            Self::Never => false,
            Self::Cells(cells) => cells[i] == ESCAPE,
            Self::Distances(t) => t[i] == f64::INFINITY,
        }
    }

    /// Rows of a range that escape.
    pub(super) fn count(self, rows: Range<usize>) -> u64 {
        match self {
            Self::Never => 0,
            Self::Cells(cells) => counted(&cells[rows], |cell| cell == ESCAPE),
            Self::Distances(t) => counted(&t[rows], |t| t == f64::INFINITY),
        }
    }
}

/// The entries for which `holds` is true.
fn counted<T: Copy>(all: &[T], holds: impl Fn(T) -> bool) -> u64 {
    let mut count = 0;
    freepath_draws::simd::dispatch(
        #[inline(always)]
        || count = all.iter().map(|&one| u32::from(holds(one))).sum::<u32>(),
    );
    u64::from(count)
}

/// The prefixes inside a first block.
pub(super) fn early(scores: &[i16], escaped: Escaped) -> Vec<Prefix> {
    let lengths = (SHORTEST.trailing_zeros()..).map(|power| 1usize << power);
    let lengths = lengths.take_while(|&rows| rows <= scores.len());
    lengths.map(|rows| prefix(&scores[..rows], escaped)).collect()
}

fn prefix(scores: &[i16], escaped: Escaped) -> Prefix {
    let sum = |of: fn(i64) -> i64| scores.iter().map(|&score| of(i64::from(score))).sum();
    Prefix::new(scores.len() as u64, [sum(|score| score), sum(i64::abs)], escaped.count(0..scores.len()))
}

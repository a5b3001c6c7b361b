//! Rows with and without order, for tests.

use crate::tally::{BlockRows, Edges, Escaped, Kept, MOST_ROWS, Scored, Sequence, SequencePart};
use freepath_draws::Key;
use freepath_draws::random::uniform;

/// Independent rows, uniform on [0, 1).
pub(crate) fn right(n: usize, seed: u64) -> Vec<f64> {
    let mut rng = Key { seed, ..Key::default() }.rng();
    (0..n).map(|_| uniform(&mut rng)).collect()
}

/// The second half mirrors the first.
pub(crate) fn antithetic_half(rows: &[f64]) -> Vec<f64> {
    let half = &rows[..rows.len() / 2];
    half.iter().copied().chain(half.iter().map(|u| 1.0 - u)).collect()
}

/// Every 32nd row is the one 16 before it.
pub(crate) fn linked(rows: &[f64]) -> Vec<f64> {
    let mut rows = rows.to_vec();
    (16..rows.len()).step_by(32).for_each(|i| rows[i] = rows[i - 16]);
    rows
}

/// Free paths (T = 0.2) whose extinction rises by `share` twice over 5000 rows, and falls back.
pub(crate) fn sawtooth(rows: &[f64], share: f64) -> Vec<f64> {
    let factor = |i: usize| 1.0 + share * (2.0 * (i % 5000) as f64 / 5000.0 - 1.0);
    scaled(rows, factor)
}

/// Free paths (T = 0.2) whose extinction is off by a share up to `share` in each block of `size` rows.
pub(crate) fn drifting_blocks(rows: &[f64], size: usize, share: f64) -> Vec<f64> {
    let shift = right(rows.len() / size + 1, 99);
    scaled(rows, |i| if shift[i / size] < 0.5 { 1.0 - share } else { 1.0 + share })
}

fn scaled(rows: &[f64], factor: impl Fn(usize) -> f64) -> Vec<f64> {
    let length = -libm::log(0.2);
    let path = |(i, u): (usize, &f64)| {
        let t = -libm::log1p(-u) / factor(i);
        if t < length { t } else { f64::INFINITY }
    };
    rows.iter().enumerate().map(path).collect()
}

/// The first rows, a power of two of them.
pub(crate) fn rows_of(rows: &[f64], escapes: bool) -> Scored {
    let mut sequence = Sequence::new(Kept::Values { values: Vec::new(), escapes }, MOST_ROWS);
    fold(&mut sequence, rows, escapes);
    sequence.first().unwrap_or(Scored { scores: Vec::new(), events: Vec::new() })
}

/// All rows, in blocks.
pub(crate) fn sequence_of(rows: &[f64]) -> Sequence {
    let mut sequence = Sequence::new(Kept::Values { values: Vec::new(), escapes: true }, MOST_ROWS);
    fold(&mut sequence, rows, true);
    sequence
}

fn fold(sequence: &mut Sequence, rows: &[f64], escapes: bool) {
    let (edges, mut scores) = (Edges::new(rows), Vec::new());
    for (block, nth) in rows.chunks(1 << 14).zip(0..) {
        edges.score(block, &mut scores);
        let kept = Some(Kept::Values { values: block.to_vec(), escapes });
        let escaped = Escaped::Distances(block);
        sequence.fold(&SequencePart::of(BlockRows { nth, scores: &scores, escaped, kept }));
    }
}

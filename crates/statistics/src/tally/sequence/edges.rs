use super::kept::score;
use std::cmp::Ordering;

/// Rows at the start of a stage from which edges are made.
pub const EDGES_FROM: usize = 4096;

/// Edges, with one more place that no number is beyond.
const PLACES: usize = 256;

/// The bins of a column whose law is not known, made from its first rows; a value that many rows share has a bin of its own. The score
/// of a bin is its mid-rank among the rows that made it.
#[derive(Clone, Debug, PartialEq)]
pub struct Edges {
    /// Increasing; NaN from the last on, which nothing is greater than or equal to.
    edges: [f64; PLACES],
    /// Of each bin: below the first edge, equal to it, between, equal to the second, ..
    scores: [i16; 2 * PLACES],
}

impl Edges {
    /// The bins of the first rows of a stage.
    #[must_use]
    pub fn new(first: &[f64]) -> Self {
        let mut rows: Vec<f64> = first.iter().take(EDGES_FROM).copied().collect();
        rows.sort_unstable_by(|a, b| a.partial_cmp(b).unwrap_or(Ordering::Equal));
        let mut edges = [f64::NAN; PLACES];
        let mut held = 0;
        for i in 1..PLACES {
            let at = rows.get(i * rows.len() / PLACES).copied().unwrap_or(f64::NAN);
            if held == 0 || edges[held - 1] < at {
                edges[held] = at;
                held += 1;
            }
        }
        let mut of = Self { edges, scores: [0; 2 * PLACES] };
        of.rank(&rows);
        of
    }

    fn rank(&mut self, rows: &[f64]) {
        let mut counts = [0; 2 * PLACES];
        rows.iter().for_each(|&row| counts[self.bin(row)] += 1);
        let mut less = 0;
        for (count, of) in counts.iter().zip(&mut self.scores) {
            *of = if rows.is_empty() { 0 } else { score(2 * less + count, 2 * rows.len()) };
            less += count;
        }
    }

    /// The bin of a value, by halves: each step is taken or not without a branch, so that several values are on their way at once.
    #[inline(always)]
    fn bin(&self, value: f64) -> usize {
        let mut below = 0;
        for step in [128, 64, 32, 16, 8, 4, 2, 1] {
            let edge = self.edges[(below + step - 1) % PLACES]; // never beyond: the remainder spares a check
            below += usize::from(edge < value) * step;
        }
        let edge = self.edges[below % PLACES];
        2 * (below % PLACES) + usize::from(edge.total_cmp(&value).is_eq())
    }

    /// The score of each value.
    pub fn score(&self, values: &[f64], scores: &mut Vec<i16>) {
        scores.clear();
        scores.extend(values.iter().map(|&value| self.scores[self.bin(value)]));
    }
}

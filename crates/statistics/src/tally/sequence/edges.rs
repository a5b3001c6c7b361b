use super::kept::score;
use std::cmp::Ordering;

/// Rows at the start of a stage from which edges are made.
pub const EDGES_FROM: usize = 4096;

/// Edges, with one more place that no number is beyond.
const PLACES: usize = 256;

/// Edges that are compared with a value at once.
const SIXTEEN: usize = 16;

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

    /// The bin of a value: the edges below it are counted by sixteens, then one by one, all at once either time.
    #[inline(always)]
    fn bin(&self, value: f64) -> usize {
        let (sixteens, _) = self.edges.as_chunks::<SIXTEEN>();
        let whole: u32 = sixteens.iter().map(|edges| u32::from(edges[SIXTEEN - 1] < value)).sum();
        let Some(edges) = sixteens.get(whole as usize) else { return 2 * PLACES - 1 }; // the last edge is none
        let more: u32 = edges.iter().map(|&edge| u32::from(edge < value)).sum();
        let below = SIXTEEN * whole as usize + more as usize;
        2 * below + usize::from(self.edges.get(below) == Some(&value))
    }

    /// The score of each value.
    pub fn score(&self, values: &[f64], scores: &mut Vec<i16>) {
        scores.clear();
        scores.resize(values.len(), 0);
        freepath_draws::simd::dispatch(
            #[inline(always)]
            || {
                for (score, &value) in scores.iter_mut().zip(values) {
                    *score = self.scores[self.bin(value)];
                }
            },
        );
    }
}

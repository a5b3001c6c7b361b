use crate::law::equal_shares;
use crate::tally::{Bins, WeighedSums};
use std::ops::Range;

/// The law of a distance under its weights: E[w; t in a bin].
#[derive(Clone, Debug, PartialEq)]
pub struct WeightedLaw {
    /// Where bins begin and end.
    edges: Vec<f64>,
    /// E[w; t in the bin].
    mass: Vec<f64>,
    /// The most by which any E[w; t <= edge] may be off; a bin, which has two edges, twice as much.
    pub(super) slack: f64,
}

/// Neighbouring bins, what is due there, and the sums of w, w^2 and w^3.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Part {
    /// From where to where in t.
    pub(super) place: Range<f64>,
    pub(super) due: f64,
    pub(super) sums: [f64; 3],
}

impl WeightedLaw {
    /// The law of `between(a, b)` = E[w; a <= t < b], known up to `slack` at any one edge.
    #[must_use]
    pub fn new(bins: &Bins, slack: f64, between: impl Fn(f64, f64) -> f64) -> Self {
        let mass = bins.edges().windows(2).map(|w| between(w[0], w[1])).collect();
        Self { edges: bins.edges().to_vec(), mass, slack }
    }

    /// At most `wanted` parts of nearly equal expectation, with the sums of column `k`.
    pub(super) fn parts(&self, wanted: usize, sums: &WeighedSums, k: usize) -> Vec<Part> {
        let mut below = vec![0.0];
        self.mass.iter().for_each(|mass| below.push(below[below.len() - 1] + mass));
        let bins: Vec<[f64; 3]> = sums.column(k).collect();
        let bounds = equal_shares(self.mass.len(), wanted, |bin| below[bin]);
        let part = |w: &[usize]| Part {
            place: self.edges[w[0]]..self.edges[w[1]],
            due: self.mass[w[0]..w[1]].iter().sum(),
            sums: added(&bins[w[0]..w[1]]),
        };
        bounds.windows(2).map(part).collect()
    }
}

fn added(sums: &[[f64; 3]]) -> [f64; 3] {
    std::array::from_fn(|power| sums.iter().map(|sums| sums[power]).sum())
}

impl Part {
    /// Both, one behind the other.
    pub(super) fn with(&self, next: &Self) -> Self {
        Self {
            place: self.place.start..next.place.end,
            due: self.due + next.due,
            sums: added(&[self.sums, next.sums]),
        }
    }

    pub(super) fn is_finite(&self) -> bool {
        self.due.is_finite() && self.sums.iter().all(|sum| sum.is_finite())
    }

    /// All of `parts` together.
    pub(super) fn of(parts: &[Self]) -> Option<Self> {
        let (first, rest) = parts.split_first()?;
        Some(rest.iter().fold(first.clone(), |all, next| all.with(next)))
    }

    /// The same with the weights of `whole` if it has none of its own that tell how large they are.
    pub(super) fn sized(&self, whole: &Self) -> [f64; 3] {
        if self.sums[2] > 0.0 { self.sums } else { whole.sums }
    }
}

//! A cell of a table.

/// A stretch of the ray, and mu at evenly spaced places of it, both ends included.
pub(super) struct Cell {
    pub(super) start: f64,
    pub(super) end: f64,
    pub(super) mu: Vec<f64>,
}

impl Cell {
    /// Place `k` of `parts` equal steps from `start` to `end`, which it meets exactly.
    pub(super) fn place(start: f64, end: f64, k: usize, parts: usize) -> f64 {
        if k == parts { end } else { start + (end - start) * k as f64 / parts as f64 }
    }

    /// t and mu of each row.
    pub(super) fn rows(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let parts = self.mu.len() - 1;
        self.mu.iter().enumerate().map(move |(k, &mu)| (Self::place(self.start, self.end, k, parts), mu))
    }
}

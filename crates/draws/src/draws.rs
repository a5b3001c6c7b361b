//! A block of draws.

/// Columns of one block: row `i` is the `i`-th draw *started*. An empty column is not wanted, and costs nothing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Draws {
    /// How many draws the block holds.
    pub rows: usize,
    /// Free path in length units, or infinity for an escape.
    pub t: Vec<f64>,
    /// Statistical weight, 1 unless signed or weighted; for a transmittance estimator, the estimate.
    pub weight: Vec<f64>,
    /// Tentative collisions of the walk.
    pub collisions: Vec<u32>,
    /// A number in [0, 1) that goes with the draw and says nothing of its distance, such as (1 + cosine) / 2 of the
    /// direction that it started in.
    pub mark: Vec<f64>,
    /// One column per channel: the weight of a chromatic draw.
    pub channels: Vec<Vec<f64>>,
}

impl Draws {
    /// A block of `rows` draws with no column.
    #[must_use]
    pub fn new(rows: usize) -> Self {
        Self { rows, ..Self::default() }
    }

    /// The same with a column of free paths. Unwritten rows are NaN, which every test rejects.
    #[must_use]
    pub fn with_t(self) -> Self {
        Self { t: vec![f64::NAN; self.rows], ..self }
    }

    /// The same with a column of weights.
    #[must_use]
    pub fn with_weight(self) -> Self {
        Self { weight: vec![f64::NAN; self.rows], ..self }
    }

    /// The same with a column of collision counts.
    #[must_use]
    pub fn with_collisions(self) -> Self {
        Self { collisions: vec![0; self.rows], ..self }
    }

    /// The same with a column of marks.
    #[must_use]
    pub fn with_mark(self) -> Self {
        Self { mark: vec![f64::NAN; self.rows], ..self }
    }

    /// The same with a column of weights for each of `channels` channels.
    #[must_use]
    pub fn with_channels(self, channels: usize) -> Self {
        Self { channels: vec![vec![f64::NAN; self.rows]; channels], ..self }
    }

    /// Writes one row into the columns that are wanted.
    #[inline(always)]
    pub fn put(&mut self, row: usize, t: f64, weight: f64, collisions: u32) {
        if let Some(x) = self.t.get_mut(row) {
            *x = t;
        }
        if let Some(x) = self.weight.get_mut(row) {
            *x = weight;
        }
        if let Some(x) = self.collisions.get_mut(row) {
            *x = collisions;
        }
    }
}

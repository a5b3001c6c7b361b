/// One draw of a free path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreePath {
    /// Distance to the collision; infinity for an escape.
    pub t: f64,
    /// Statistical weight: 1 unless the sampler is weighted.
    pub weight: f64,
    /// Tentative collisions of the walk, 0 if it makes none.
    pub collisions: u32,
}

impl FreePath {
    /// An unweighted collision at `t`, or escape if `t` is infinite.
    #[must_use]
    pub fn at(t: f64) -> Self {
        Self { t, weight: 1.0, collisions: 0 }
    }
}

/// One draw of a free path, and a number that comes with it and says nothing of its distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AuxiliaryPath {
    /// The path.
    pub path: FreePath,
    /// The number, in [0, 1).
    pub auxiliary: f64,
}

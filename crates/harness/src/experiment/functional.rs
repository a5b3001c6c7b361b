use freepath_draws::Draws;

/// A mean of one subject: a number for each draw, and what it should be on average.
#[derive(Clone, Copy, Debug)]
pub struct Functional {
    /// The number of the first row of a block.
    pub value: fn(&Draws) -> f64,
    /// The mean that is claimed.
    pub expected: f64,
    /// The bias of the method's own mean, by design.
    pub declared: f64,
    /// The relative error of what is expected.
    pub relative_error: f64,
}

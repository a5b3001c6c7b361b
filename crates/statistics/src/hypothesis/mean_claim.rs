/// The claim on a mean.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeanClaim {
    /// The value.
    pub expected: f64,
    /// The most by which it may be off: error of tau, and a declared tolerance.
    pub slack: f64,
    /// Every draw is 0 or 1.
    pub binary: bool,
    /// Least and greatest value of a draw.
    pub range: Option<(f64, f64)>,
    /// Exact variance, where known.
    pub variance: Option<f64>,
    /// Exact skewness, or a size that it cannot be far below, where known; NaN if not.
    pub skewness: Option<f64>,
}

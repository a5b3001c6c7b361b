/// Extinction at places along a ray: `mu[i]` at `t[i]`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Nodes {
    /// Places, increasing from 0; the same twice where extinction may jump.
    pub t: Vec<f64>,
    /// Extinction there, 1/length, finite and not negative.
    pub mu: Vec<f64>,
}

/// The nodes that a description wants.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NodesRequest<'a> {
    /// A name relative to the case file.
    pub file: &'a str,
    /// The column of t, by name or by number from 0; none for the one that is called so, or the first.
    pub t: Option<&'a str>,
    /// The column of mu, by name or by number from 0; none for the one that is called so, or the second of two.
    pub mu: Option<&'a str>,
    /// Two rows of the same t are a jump.
    pub jumps: bool,
}

impl Nodes {
    /// The most rows.
    pub const MOST: usize = 1_000_000;
}

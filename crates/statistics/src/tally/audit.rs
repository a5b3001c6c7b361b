use std::fmt;

/// The record of some look-ups.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Audit {
    /// All look-ups.
    pub lookups: u64,
    /// At t outside [0, length], or NaN.
    pub outside: u64,
    /// With mu above the majorant beyond rounding, negative, or NaN.
    pub above: u64,
    /// The worst of those.
    pub worst: Option<Excess>,
}

/// A look-up whose mu is not within its bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Excess {
    /// The place.
    pub t: f64,
    /// The value of mu found there.
    pub mu: f64,
    /// The majorant there.
    pub bound: f64,
}

impl Excess {
    /// The one of the larger excess, NaN being the largest, and of equal ones the first along the ray: in any order of merging
    /// the same.
    #[must_use]
    pub fn worse(self, other: Self) -> Self {
        let excess = |of: Self| (of.mu - of.bound).abs();
        let order = excess(self).total_cmp(&excess(other)).then(other.t.total_cmp(&self.t));
        if order.is_lt() { other } else { self }
    }
}

impl fmt::Display for Excess {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "at t = {}, where mu is {} and the majorant {}", self.t, self.mu, self.bound)
    }
}

impl Audit {
    /// Both together.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            lookups: self.lookups + other.lookups,
            outside: self.outside + other.outside,
            above: self.above + other.above,
            worst: match (self.worst, other.worst) {
                (Some(one), Some(two)) => Some(one.worse(two)),
                (one, two) => one.or(two),
            },
        }
    }
}

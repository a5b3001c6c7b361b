/// The category of a uniform.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Picked {
    /// The category, from 0 on.
    pub index: usize,
    /// The place of the uniform inside the piece of [0, 1) that belongs to it.
    pub remapped: f64,
}

impl Picked {
    /// The category `index`, to which the piece from `from` to `to` belongs, where `u` lies.
    pub(super) fn inside(index: usize, u: f64, from: f64, to: f64) -> Self {
        const BELOW_ONE: f64 = 1.0 - 0.5 * f64::EPSILON;
        let share = (u - from) / (to - from);
        // the quotient of two numbers that are nearly equal may be rounded up
        Self { index, remapped: if share > BELOW_ONE { BELOW_ONE } else { share } }
    }
}

/// The category at place `index` of a cumulative table, where `u` lies.
pub(super) fn from_cumulative(cumulative: &[f64], index: usize, u: f64) -> Picked {
    let from = if index == 0 { 0.0 } else { cumulative[index - 1] };
    Picked::inside(index, u, from, cumulative[index])
}

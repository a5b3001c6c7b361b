/// 2^52: adding it rounds to an integer and shows it in the low bits.
pub(super) const INTEGERS: f64 = 4_503_599_627_370_496.0;

/// `u` held to [0, top]; NaN stays.
#[inline(always)]
pub(super) fn hold(u: f64, top: f64) -> f64 {
    let u = if u < 0.0 { 0.0 } else { u };
    if u > top { top } else { u }
}

/// A cell, and a place in it.
pub(super) struct Located {
    pub(super) cell: f64,
    /// From 0 to 1.
    pub(super) place: f64,
}

/// The course of the ray along one axis, in cells of the filter: cell k lies between the positions k and k + 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Axis {
    /// Position at t = 0.
    pub(super) start: f64,
    /// Cells per length.
    pub(super) slope: f64,
    /// The value there is held beyond this position, as the value at 0 is below it.
    pub(super) top: f64,
    /// The last cell.
    pub(super) last: f64,
}

impl Axis {
    #[inline(always)]
    pub(super) fn position(&self, t: f64) -> f64 {
        self.start + t * self.slope
    }

    /// The cell at `t`, and the place in it from 0 to 1.
    #[inline(always)]
    pub(super) fn locate(&self, t: f64) -> Located {
        let u = hold(self.position(t), self.top);
        let near = (u + INTEGERS) - INTEGERS;
        let floor = if near > u { near - 1.0 } else { near };
        let cell = if floor > self.last { self.last } else { floor };
        Located { cell, place: u - cell }
    }
}

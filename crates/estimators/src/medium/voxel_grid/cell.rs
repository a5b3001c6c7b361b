use super::axis::hold;
use super::cubic::{Cubic, widen};
use super::filter::Filter;
use super::line::{Corner, Line};

/// mu between two knots, and the range that no look-up there leaves, whatever the place and the rounding.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    pub(super) mu: Cubic,
    least: f64,
    most: f64,
    /// The most that a look-up may lie from `mu` by rounding.
    rounding: f64,
}

impl Cell {
    pub(super) fn new(line: &Line, start: f64, end: f64) -> Self {
        match line.grid().filter() {
            Filter::Nearest => Self::constant(line.mu(start)),
            Filter::Trilinear => Self::cubic(line, start, end),
        }
    }

    /// The cell that starts at `start`, which every look-up before `end` reads.
    fn cubic(line: &Line, start: f64, end: f64) -> Self {
        let Corner { index, place: from } = line.locate(start);
        let to = std::array::from_fn(|a| {
            let axis = &line.axes()[a];
            hold(hold(axis.position(end), axis.top) - axis.locate(start).cell, 1.0)
        });
        let corners = line.corners(index);
        let none = (f64::INFINITY, f64::NEG_INFINITY);
        let (least, most) = corners.into_iter().fold(none, widen);
        let blended = if least < most { 4.0 * f64::EPSILON * most } else { 0.0 };
        let planes: usize = line.grid().shape().iter().sum();
        Self {
            mu: Cubic::along(&corners, from, to),
            least: hold(least - blended, most),
            most: most + blended,
            rounding: 2.0 * blended + 3.0 * f64::EPSILON * planes as f64 * (most - least),
        }
    }

    fn constant(mu: f64) -> Self {
        Self { mu: Cubic::constant(mu), least: mu, most: mu, rounding: 0.0 }
    }

    /// The range of look-ups from `from` to `to` of the cell.
    pub(super) fn range(&self, from: f64, to: f64) -> (f64, f64) {
        let (low, high) = self.mu.range(from, to);
        let (low, high) = (low - self.rounding, high + self.rounding);
        (if low < self.least { self.least } else { low }, if high > self.most { self.most } else { high })
    }
}

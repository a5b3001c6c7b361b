use super::cubic::{Cubic, widen};
use super::grid::Filter;
use super::knots;
use super::line::{Line, hold};
use crate::extinction::{Cells, Extinction, Medium};
use crate::majorants::Majorants;

/// Extinction along one ray through a [`Grid`](super::Grid), with its exact optical depth.
///
/// `mu` looks up the grid as a renderer does; the truth comes from one cubic per cell along the ray.
#[derive(Clone, Debug)]
pub struct GridRay {
    line: Line,
    /// 0, each turn to another cell, the length.
    knots: Vec<f64>,
    cells: Vec<Cell>,
    /// Optical depth at the knots.
    depths: Vec<f64>,
    breaks: Vec<f64>,
    majorants: Majorants,
}

/// mu between two knots, and the range that no look-up there leaves, whatever the place and the rounding.
#[derive(Clone, Copy, Debug)]
struct Cell {
    mu: Cubic,
    least: f64,
    most: f64,
    /// How far a look-up may lie from `mu` by rounding.
    rounding: f64,
}

impl Cell {
    fn new(line: &Line, start: f64, end: f64) -> Self {
        match line.grid().filter() {
            Filter::Nearest => Self::constant(line.mu(start)),
            Filter::Trilinear => Self::cubic(line, start, end),
        }
    }

    /// The cell that starts at `start`, which every look-up before `end` reads.
    fn cubic(line: &Line, start: f64, end: f64) -> Self {
        let (index, from) = line.locate(start);
        let to = std::array::from_fn(|a| {
            let axis = &line.axes()[a];
            hold(hold(axis.position(end), axis.top) - axis.locate(start).0, 1.0)
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

    /// What look-ups from `from` to `to` of the cell can give.
    fn range(&self, from: f64, to: f64) -> (f64, f64) {
        let (low, high) = self.mu.range(from, to);
        let (low, high) = (low - self.rounding, high + self.rounding);
        (if low < self.least { self.least } else { low }, if high > self.most { self.most } else { high })
    }
}

impl GridRay {
    pub(super) fn new(line: Line, length: f64) -> Self {
        let knots = knots::knots(&line, length);
        let spans = knots.windows(2);
        let cells: Vec<Cell> = spans.map(|span| Cell::new(&line, span[0], span[1])).collect();
        let unbounded = Self {
            depths: depths(&knots, &cells),
            breaks: knots::breaks(&knots),
            line,
            knots,
            cells,
            majorants: Majorants::default(),
        };
        Self { majorants: Majorants::tight(&unbounded, 1), ..unbounded }
    }

    /// The cell at `t`, closed to the left.
    fn cell(&self, t: f64) -> usize {
        self.knots[1..self.cells.len()].partition_point(|&knot| knot <= t)
    }

    fn width(&self, i: usize) -> f64 {
        self.knots[i + 1] - self.knots[i]
    }

    /// `t` as a place in cell `i`, held to [0, 1].
    fn place(&self, i: usize, t: f64) -> f64 {
        hold((t - self.knots[i]) / self.width(i), 1.0)
    }
}

/// The optical depth at each knot, summed with the rounding error of each sum carried along (Kahan 1965).
fn depths(knots: &[f64], cells: &[Cell]) -> Vec<f64> {
    let (mut sum, mut lost) = (0.0, 0.0);
    let parts = knots.windows(2).zip(cells).map(|(span, cell)| {
        let part = (span[1] - span[0]) * cell.mu.integral(1.0) - lost;
        let next = sum + part;
        lost = (next - sum) - part;
        sum = next;
        sum
    });
    std::iter::once(0.0).chain(parts).collect()
}

impl Extinction for GridRay {
    fn length(&self) -> f64 {
        self.knots[self.cells.len()]
    }
    #[inline(always)]
    fn mu(&self, t: f64) -> f64 {
        self.line.mu(t)
    }
    fn majorants(&self) -> &Majorants {
        &self.majorants
    }
    fn breaks(&self) -> &[f64] {
        &self.breaks
    }
    fn cells(&self) -> Cells {
        match self.line.grid().filter() {
            Filter::Nearest => Cells::Constant,
            Filter::Trilinear => Cells::Cubic,
        }
    }
    fn mu_tile(&self, t: &[f64], mu: &mut [f64]) {
        self.line.mu_tile(t, mu);
    }
}

impl Medium for GridRay {
    fn tau(&self, t: f64) -> f64 {
        let i = self.cell(t);
        self.depths[i] + self.width(i) * self.cells[i].mu.integral(self.place(i, t))
    }
    fn inverse_tau(&self, depth: f64) -> f64 {
        if depth >= self.depths[self.cells.len()] {
            return f64::INFINITY;
        }
        if depth <= 0.0 {
            return 0.0;
        }
        let i = self.depths[1..].partition_point(|&reached| reached < depth);
        let part = (depth - self.depths[i]) / self.width(i);
        self.knots[i] + self.width(i) * self.cells[i].mu.reach(part)
    }
    fn extrema(&self, a: f64, b: f64) -> (f64, f64) {
        let mut range = widen((self.mu(a), self.mu(a)), self.mu(b));
        for i in self.cell(a)..=self.cell(b) {
            let (low, high) = self.cells[i].range(self.place(i, a), self.place(i, b));
            range = widen(widen(range, low), high);
        }
        range
    }
}

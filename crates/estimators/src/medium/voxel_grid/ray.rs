use super::axis::hold;
use super::bounds;
use super::cell::Cell;
use super::cubic::widen;
use super::filter::Filter;
use super::grid::Grid;
use super::knots;
use super::line::Line;
use crate::extinction::{Cells, Extinction, Medium};
use crate::majorants::Majorants;
use crate::parameter::{self, ParameterError};

/// Extinction along one ray through a [`Grid`], with its exact optical depth.
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

impl Grid {
    /// Extinction along the ray from `origin` in `direction`, whose length does not matter.
    ///
    /// # Errors
    /// If a number is not finite, the direction is zero, or the ray misses the box.
    pub fn ray(&self, origin: [f64; 3], direction: [f64; 3]) -> Result<GridRay, ParameterError> {
        let unit = bounds::unit(direction)?;
        for x in origin {
            parameter::finite("origin", x)?;
        }
        let missed = || {
            let ray = format!("{origin:?} along {direction:?}");
            ParameterError::new("origin", ray, "that of a ray which crosses the bounds")
        };
        let inside = self.bounds().enter(self.shape(), origin, unit).ok_or_else(missed)?;
        let axis = |a| self.filter().axis(self.shape()[a], inside.start[a], inside.slope[a]);
        let line = Line::new(self.clone(), std::array::from_fn(axis));
        Ok(GridRay::new(line, inside.length))
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
    fn tau_error(&self) -> f64 {
        0.0
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

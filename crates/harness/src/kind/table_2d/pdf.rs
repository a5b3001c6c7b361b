//! The density that a sampler of a table tells: with each draw, and of any place.

use crate::identities;
use freepath_draws::{CompensatedSum, Draws};
use freepath_estimators::Table2dSampler;
use freepath_estimators::table_2d::{Grid, PDF, Place, X, Y};
use freepath_statistics::Fact;
use freepath_statistics::hypothesis::PdfMass;

/// Cells at whose middles a density is asked for, at the most: further ones are left to the integral.
const MOST: usize = 4096;
/// Parts of a cell for the finer rule, along each side.
const FINER: usize = 2;

/// The integral over the rectangle of the density that a sampler tells, from the middles of cells, and from those of their quarters.
pub(super) fn mass(sampler: &dyn Table2dSampler, grid: &Grid) -> PdfMass {
    let [integral, finer] = [1, FINER].map(|parts| {
        let mut sum = CompensatedSum::default();
        middles(grid, parts).for_each(|at| sum.add(sampler.pdf(grid, at)));
        let cells = grid.rows() * grid.columns() * parts * parts;
        sum.value() * grid.area() / cells as f64
    });
    PdfMass { integral, error: 0.0, finer }
}

/// The first density of a draw that is not that of the scene: the one that came with it, or the one that the sampler tells of it.
pub(super) fn wrong_with_a_draw(
    sampler: &dyn Table2dSampler,
    grid: &Grid,
    draws: &Draws,
    tolerance: f64,
) -> Option<Fact> {
    let (x, y, pdf) = (draws.f64(X).ok()?, draws.f64(Y).ok()?, draws.f64(PDF).ok()?);
    let mut rows = x.iter().zip(y).zip(pdf);
    rows.find_map(|((&x, &y), &pdf)| {
        let at = Place { x, y };
        compared(grid, at, pdf, tolerance).or_else(|| compared(grid, at, sampler.pdf(grid, at), tolerance))
    })
}

/// The first density that a sampler tells of a place, drawn or not, and that is not that of the scene: in up to 4096 cells, and 0
/// beyond both ends of each row and column.
pub(super) fn wrong_anywhere(sampler: &dyn Table2dSampler, grid: &Grid, tolerance: f64) -> Option<Fact> {
    let step = (grid.rows() * grid.columns()).div_ceil(MOST);
    let mut places = middles(grid, 1).step_by(step).chain(outside(grid));
    places.find_map(|at| compared(grid, at, sampler.pdf(grid, at), tolerance))
}

/// The middles of all cells, or of so many parts along each of their sides.
fn middles(grid: &Grid, parts: usize) -> impl Iterator<Item = Place> {
    let ([x, y], columns, rows) = (grid.domain(), grid.columns() * parts, grid.rows() * parts);
    (0..rows)
        .flat_map(move |i| (0..columns).map(move |j| Place { x: middle(x, j, columns), y: middle(y, i, rows) }))
}

/// Places beyond both ends of each row and of each column, where a density must not be that of the cell nearby.
fn outside(grid: &Grid) -> impl Iterator<Item = Place> {
    let [x, y] = grid.domain();
    let beyond = |[a, b]: [f64; 2]| [a - 0.1 * (b - a), b + 0.1 * (b - a)];
    let of_rows = (0..grid.rows()).map(move |i| middle(y, i, grid.rows()));
    let of_columns = (0..grid.columns()).map(move |j| middle(x, j, grid.columns()));
    let left_and_right = of_rows.flat_map(move |y| beyond(x).map(|x| Place { x, y }));
    let below_and_above = of_columns.flat_map(move |x| beyond(y).map(|y| Place { x, y }));
    left_and_right.chain(below_and_above)
}

/// The middle of one of `n` parts of a side.
fn middle([from, to]: [f64; 2], i: usize, n: usize) -> f64 {
    from + (to - from) * ((i as f64 + 0.5) / n as f64)
}

fn compared(grid: &Grid, at: Place, pdf: f64, tolerance: f64) -> Option<Fact> {
    identities::density::told(&format!("x = {}, y = {}", at.x, at.y), pdf, grid.pdf(at), tolerance)
}

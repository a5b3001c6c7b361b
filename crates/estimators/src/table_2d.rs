//! Samplers of a table over a rectangle: places whose density is constant in each of its cells.

use freepath_draws::{Draws, NumbersMut, Streams};

mod grid;
mod grid_tables;
mod marginal_conditional;
mod side;

pub use grid::{Grid, Place};
pub use grid_tables::GridTables;

use crate::capability::Capability;

/// The column of the places along a row of the table.
pub const X: &str = "x";

/// The column of the places across its rows.
pub const Y: &str = "y";

/// The column of the densities that come with them, 1/area.
pub const PDF: &str = "pdf";

/// A place and its density.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drawn {
    /// The place.
    pub at: Place,
    /// The density there, per area.
    pub pdf: f64,
}

/// Draws places that follow a table, and tells the density of each.
pub trait Table2dSampler: Send + Sync {
    /// One place.
    fn sample(&self, grid: &Grid, rng: &mut dyn rand::Rng) -> Drawn;

    /// The density of any place, per area; 0 outside the rectangle.
    fn pdf(&self, grid: &Grid, at: Place) -> f64;

    /// The uniforms that a place is made of, in the order in which they are drawn. Provided: it is not inverted.
    fn invert(&self, _grid: &Grid, _at: Place) -> Option<[f64; 2]> {
        None
    }

    /// One place for each row of `out`. Provided: a loop over [`Table2dSampler::sample`].
    fn sample_block(&self, grid: &Grid, streams: &Streams, out: &mut Draws) {
        let mut rng = streams.rng();
        let drawn: Vec<Drawn> = (0..out.rows()).map(|_| self.sample(grid, &mut rng)).collect();
        write(&drawn, out);
    }

    /// Its capabilities, for faults. Provided: none.
    fn capabilities(&self) -> Vec<Capability> {
        Vec::new()
    }
}

/// Writes places and densities to the columns [`X`], [`Y`] and [`PDF`]; one that the block does not have is not wanted.
pub fn write(drawn: &[Drawn], out: &mut Draws) {
    for (column, numbers) in out.columns_mut() {
        match (column.name(), numbers) {
            (X, NumbersMut::F64(x)) => put(x, drawn, |drawn| drawn.at.x),
            (Y, NumbersMut::F64(y)) => put(y, drawn, |drawn| drawn.at.y),
            (PDF, NumbersMut::F64(pdf)) => put(pdf, drawn, |drawn| drawn.pdf),
            (_, NumbersMut::F64(_) | NumbersMut::U32(_)) => {}
        }
    }
}

fn put(column: &mut [f64], drawn: &[Drawn], of: impl Fn(&Drawn) -> f64) {
    column.iter_mut().zip(drawn).for_each(|(number, drawn)| *number = of(drawn));
}

crate::list! {
    /// Every sampler of a table over a rectangle that a case can name.
    pub enum AnyTable2d: dyn Table2dSampler {
        marginal_conditional::MarginalConditional,
    }
}

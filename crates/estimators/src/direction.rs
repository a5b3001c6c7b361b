//! Samplers of directions about a normal: unit vectors that follow a density per solid angle.

use crate::parameter::ParameterError;
use freepath_draws::{Draws, NumbersMut, Streams};

mod axial;
mod cone;
mod cosine_hemisphere;
mod frame;
mod law;
mod uniform_hemisphere;
mod uniform_sphere;

pub use frame::Frame;
pub use law::{DirectionLaw, Directions, Ranks, is_unit};

/// Three coordinates in the world.
pub type Vector = [f64; 3];

/// The column of the first coordinate.
pub const X: &str = "x";

/// The column of the second coordinate.
pub const Y: &str = "y";

/// The column of the third coordinate.
pub const Z: &str = "z";

/// The column of the densities that come with directions, 1/steradian.
pub const PDF: &str = "pdf";

/// A direction and its density.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drawn {
    /// The direction: a unit vector.
    pub w: Vector,
    /// The density there, 1/steradian.
    pub pdf: f64,
}

/// Draws directions about a normal, and tells the density of each.
pub trait DirectionSampler: Send + Sync {
    /// One direction about a normal, which is a unit vector.
    fn sample(&self, normal: Vector, rng: &mut dyn rand::Rng) -> Drawn;

    /// One direction for each row of `out`. Provided: a loop over [`DirectionSampler::sample`].
    fn sample_block(&self, normal: Vector, streams: &Streams, out: &mut Draws) {
        let mut rng = streams.rng();
        let drawn: Vec<Drawn> = (0..out.rows()).map(|_| self.sample(normal, &mut rng)).collect();
        write(&drawn, 0, out);
    }

    /// The density of any unit vector, 1/steradian: 0 where none is drawn.
    fn pdf(&self, normal: Vector, w: Vector) -> f64;

    /// Refuses parameters under which nothing can be drawn. Provided: none.
    ///
    /// # Errors
    /// Naming the parameter.
    fn accepts(&self) -> Result<(), ParameterError> {
        Ok(())
    }
}

/// Writes directions and densities from row `first` on to the columns [`X`], [`Y`], [`Z`] and [`PDF`]; one that the block does
/// not have is not wanted.
pub fn write(drawn: &[Drawn], first: usize, out: &mut Draws) {
    for (column, numbers) in out.columns_mut() {
        match (column.name(), numbers) {
            (X, NumbersMut::F64(x)) => put(x, first, drawn, |drawn| drawn.w[0]),
            (Y, NumbersMut::F64(y)) => put(y, first, drawn, |drawn| drawn.w[1]),
            (Z, NumbersMut::F64(z)) => put(z, first, drawn, |drawn| drawn.w[2]),
            (PDF, NumbersMut::F64(pdf)) => put(pdf, first, drawn, |drawn| drawn.pdf),
            (_, NumbersMut::F64(_) | NumbersMut::U32(_)) => {}
        }
    }
}

fn put(column: &mut [f64], first: usize, drawn: &[Drawn], of: impl Fn(&Drawn) -> f64) {
    column[first..].iter_mut().zip(drawn).for_each(|(number, drawn)| *number = of(drawn));
}

crate::list! {
    /// Every sampler of directions that a case can name.
    pub enum AnyDirection: dyn DirectionSampler {
        uniform_sphere::UniformSphere,
        uniform_hemisphere::UniformHemisphere,
        cosine_hemisphere::CosineHemisphere,
        cone::Cone,
    }
}

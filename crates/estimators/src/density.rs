//! Samplers of a density on a line: numbers that follow a law, with atoms if it has some.

use crate::parameter::ParameterError;
use freepath_draws::{Draws, NumbersMut, Streams};

mod curve;
mod newton_bisection;
mod rejection;
mod target;

pub use curve::{Atom, Curve};
pub use target::Target;

/// The column of the numbers that are drawn.
pub const X: &str = "x";

/// The column of the densities that come with them, 1/length; of an atom, its mass.
pub const PDF: &str = "pdf";

/// A number and its density.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drawn {
    /// The number.
    pub x: f64,
    /// The density there; the mass of an atom.
    pub pdf: f64,
}

/// Draws numbers that follow a target, and tells the density of each.
pub trait DensitySampler: Send + Sync {
    /// One number.
    fn sample(&self, target: &Target, rng: &mut dyn rand::Rng) -> Drawn;

    /// One number for each row of `out`. Provided: a loop over [`DensitySampler::sample`].
    fn sample_block(&self, target: &Target, streams: &Streams, out: &mut Draws) {
        let mut rng = streams.rng();
        let drawn: Vec<Drawn> = (0..out.rows()).map(|_| self.sample(target, &mut rng)).collect();
        write(&drawn, out);
    }

    /// Refuses a target that the sampler cannot follow. Provided: none.
    ///
    /// # Errors
    /// Naming the parameter that does not fit the target.
    fn accepts(&self, _target: &Target) -> Result<(), ParameterError> {
        Ok(())
    }
}

/// Writes numbers and densities to the columns [`X`] and [`PDF`]; one that the block does not have is not wanted.
pub fn write(drawn: &[Drawn], out: &mut Draws) {
    for (column, numbers) in out.columns_mut() {
        match (column.name(), numbers) {
            (X, NumbersMut::F64(x)) => x.iter_mut().zip(drawn).for_each(|(x, drawn)| *x = drawn.x),
            (PDF, NumbersMut::F64(pdf)) => pdf.iter_mut().zip(drawn).for_each(|(pdf, drawn)| *pdf = drawn.pdf),
            (_, NumbersMut::F64(_) | NumbersMut::U32(_)) => {}
        }
    }
}

crate::list! {
    /// Every sampler of a density that a case can name.
    pub enum AnyDensity: dyn DensitySampler {
        newton_bisection::NewtonBisection,
        rejection::Rejection,
    }
}

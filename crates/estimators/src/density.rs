//! Samplers of a density on a line: numbers that follow a law, with atoms if it has some.

use crate::capability::Capability;
use crate::parameter::ParameterError;
use freepath_draws::{Draws, NumbersMut, Streams};

mod curve;
mod inversion;
mod newton_bisection;
mod rejection;
mod target;

pub use curve::{Atom, Curve};
pub use rejection::geometric;
pub use target::Target;

/// The column of the numbers that are drawn.
pub const X: &str = "x";

/// The column of the densities that come with them, 1/length; of an atom, its mass.
pub const PDF: &str = "pdf";

/// The column of the trials that a number took, where they are counted: whole numbers, from 1 on.
pub const TRIALS: &str = "trials";

/// A number and its density.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drawn {
    /// The number.
    pub x: f64,
    /// The density there; the mass of an atom.
    pub pdf: f64,
    /// The trials that it took: 1 without rejection.
    pub trials: u32,
}

impl Drawn {
    /// A number that took one trial.
    #[must_use]
    pub fn new(x: f64, pdf: f64) -> Self {
        Self { x, pdf, trials: 1 }
    }
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

    /// The uniform that a number was drawn from. Provided: it is not inverted.
    fn inverse(&self, _target: &Target, _x: f64) -> Option<f64> {
        None
    }

    /// The envelope C g(x), 1/length, under which a trial at `x` is accepted with probability p(x)/(C g(x)): trials are then geometric
    /// with mean `trials`. Provided: nothing is rejected.
    fn envelope(&self, _target: &Target, _x: f64) -> Option<f64> {
        None
    }

    /// The mean number of trials, C, if they are counted in [`TRIALS`]. Provided: they are not.
    fn trials(&self, _target: &Target) -> Option<f64> {
        None
    }

    /// Its capabilities, for faults. Provided: none.
    fn capabilities(&self) -> Vec<Capability> {
        Vec::new()
    }

    /// Refuses a target that the sampler cannot follow. Provided: none.
    ///
    /// # Errors
    /// Naming the parameter that does not fit the target.
    fn accepts(&self, _target: &Target) -> Result<(), ParameterError> {
        Ok(())
    }
}

/// Writes numbers, densities and trials to the columns [`X`], [`PDF`] and [`TRIALS`]; one that the block does not have is not wanted.
pub fn write(drawn: &[Drawn], out: &mut Draws) {
    for (column, numbers) in out.columns_mut() {
        match (column.name(), numbers) {
            (X, NumbersMut::F64(x)) => x.iter_mut().zip(drawn).for_each(|(x, drawn)| *x = drawn.x),
            (PDF, NumbersMut::F64(pdf)) => pdf.iter_mut().zip(drawn).for_each(|(pdf, drawn)| *pdf = drawn.pdf),
            (TRIALS, NumbersMut::F64(n)) => {
                n.iter_mut().zip(drawn).for_each(|(n, drawn)| *n = f64::from(drawn.trials))
            }
            (_, NumbersMut::F64(_) | NumbersMut::U32(_)) => {}
        }
    }
}

crate::list! {
    /// Every sampler of a density that a case can name.
    pub enum AnyDensity: dyn DensitySampler {
        inversion::Inversion,
        newton_bisection::NewtonBisection,
        rejection::Rejection,
    }
}

//! Estimators of an integral by a density to draw from: f(x) over p(x).

use freepath_draws::{Draws, PathColumns, Streams};

mod average_of;
mod density;
mod importance;
mod integrand;
mod mixture;
mod proportional;
mod uniform;

pub use integrand::{Division, Integrand, Quotient, Sampled};

use crate::capability::Capability;
use crate::parameter::ParameterError;

/// Draws estimates of the integral of a function over an interval.
pub trait Integrator: Send + Sync {
    /// One estimate.
    fn estimate(&self, integrand: &Integrand, rng: &mut dyn rand::Rng) -> f64;

    /// One estimate for each row of `out`. Provided: a loop over [`Integrator::estimate`].
    fn estimate_block(&self, integrand: &Integrand, streams: &Streams, out: &mut Draws) {
        let (mut rng, mut columns) = (streams.rng(), PathColumns::of(out));
        for row in 0..columns.rows() {
            let estimate = self.estimate(integrand, &mut rng);
            columns.put(row, f64::INFINITY, estimate, 0);
        }
    }

    /// The density of its draws at `x`, 1/length: moments follow from it. Provided: it is not told.
    fn pdf(&self, _integrand: &Integrand, _x: f64) -> Option<f64> {
        None
    }

    /// The independent draws of which an estimate is the mean. Provided: one.
    fn draws(&self) -> u32 {
        1
    }

    /// Refuses an integrand that it cannot estimate. Provided: none.
    ///
    /// # Errors
    /// Naming the parameter that does not fit the integrand.
    fn accepts(&self, _integrand: &Integrand) -> Result<(), ParameterError> {
        Ok(())
    }

    /// Its capabilities, for faults. Provided: none.
    fn capabilities(&self) -> Vec<Capability> {
        Vec::new()
    }
}

crate::list! {
    /// Every estimator of an integral that a case can name.
    pub enum AnyIntegrator: dyn Integrator {
        uniform::Uniform,
        importance::Importance,
        mixture::Mixture,
        average_of::AverageOf,
        proportional::Proportional,
    }
}

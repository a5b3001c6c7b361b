//! Transmittance estimators.

use crate::capability::Capability;
use crate::claims::TransmittanceClaims;
use crate::extinction::{Extinction, Medium};
use crate::parameter::ParameterError;
use crate::path::FreePath;
use crate::woodcock::one_by_one;
use freepath_draws::{Draws, Streams};

mod delta_tracking;
mod ratio_roulette;
mod ratio_tracking;
mod ray_marching;
mod residual_ratio_tracking;

pub use crate::control::Control;
pub use ratio_roulette::RouletteRule;
pub use ray_marching::MarchingRule;

/// Estimates the transmittance T = exp(-tau(length)) of a ray.
pub trait TransmittanceEstimator: Send + Sync {
    /// One estimate. It sees mu and its majorants, never tau.
    fn estimate(&self, medium: &dyn Extinction, rng: &mut dyn rand::Rng) -> f64;

    /// One estimate for each row of `out`, a function of the streams alone. Provided: a loop over
    /// [`TransmittanceEstimator::estimate`].
    fn estimate_block(&self, medium: &dyn Extinction, streams: &Streams, out: &mut Draws) {
        one_by_one(streams, out, |rng| {
            let weight = self.estimate(medium, rng);
            FreePath { t: f64::INFINITY, weight, collisions: 0 }
        });
    }

    /// The claims of this estimator in this medium. Provided: that its mean is T and it needs a bounding majorant.
    fn claims(&self, _truth: &dyn Medium) -> TransmittanceClaims {
        TransmittanceClaims::default()
    }

    /// The result of a Russian roulette of this estimator for `weight` when its uniform is `u`: 0 for a death; none if it
    /// plays no roulette. Its mean over `u` must be `weight`, and is tested.
    fn roulette(&self, _weight: f64, _u: f64) -> Option<f64> {
        None
    }

    /// Its capabilities, for planted faults that need them: a fault is refused over an estimator that does not state what the
    /// fault lays hold of. Provided: nothing.
    fn capabilities(&self) -> Vec<Capability> {
        Vec::new()
    }

    /// Refuses a medium that the estimator cannot work in.
    ///
    /// # Errors
    /// Naming the parameter that does not fit the medium.
    fn accepts(&self, _medium: &dyn Extinction) -> Result<(), ParameterError> {
        Ok(())
    }
}

crate::list! {
    /// Every transmittance estimator that a case can name.
    pub enum AnyTransmittance: dyn TransmittanceEstimator {
        delta_tracking::DeltaTracking,
        ratio_roulette::RatioRoulette,
        ratio_tracking::RatioTracking,
        ray_marching::RayMarching,
        residual_ratio_tracking::ResidualRatioTracking,
    }
}

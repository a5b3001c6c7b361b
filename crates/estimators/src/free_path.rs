//! Free-path samplers.

use crate::capability::Capability;
use crate::claims::FreePathClaims;
use crate::extinction::{Extinction, Medium};
use crate::parameter::ParameterError;
use crate::path::{AuxiliaryPath, FreePath};
use crate::woodcock::one_by_one;
use freepath_draws::{Draws, PathColumns, Streams, column};

pub(crate) mod delta_tracking;
mod ray_marching;
mod regular_tracking;

pub use ray_marching::rule::MarchingRule;

/// Draws distances to the next collision: P(t <= x) = 1 - exp(-tau(x)), and escape with probability exp(-tau(length)).
///
/// One method is required. A closure `Fn(&dyn Extinction, &mut dyn Rng) -> f64` is a sampler, too.
pub trait FreePathSampler: Send + Sync {
    /// One draw. It sees mu and its majorants, never tau.
    fn sample(&self, medium: &dyn Extinction, rng: &mut dyn rand::Rng) -> FreePath;

    /// One draw for each row of `out`, a function of the streams alone. Provided: a loop over
    /// [`FreePathSampler::sample`], or [`FreePathSampler::sample_with_auxiliary`] if `out` wants auxiliary numbers.
    fn sample_block(&self, medium: &dyn Extinction, streams: &Streams, out: &mut Draws) {
        if !out.row().has(column::AUXILIARY) {
            return one_by_one(streams, out, |rng| self.sample(medium, rng));
        }
        let (mut rng, mut columns) = (streams.rng(), PathColumns::of(out));
        for row in 0..columns.rows() {
            let AuxiliaryPath { path, auxiliary } = self.sample_with_auxiliary(medium, &mut rng);
            columns.put(row, path.t, path.weight, path.collisions);
            columns.put_auxiliary(row, auxiliary);
        }
    }

    /// True if each draw comes with an auxiliary number, which is uniform on [0, 1) and independent of the distance, such as
    /// (1 + cosine) / 2 of the direction in which the path starts. Provided: false.
    fn has_auxiliary(&self) -> bool {
        false
    }

    /// One draw and its auxiliary number, if there are any. Provided: [`FreePathSampler::sample`], and NaN.
    fn sample_with_auxiliary(&self, medium: &dyn Extinction, rng: &mut dyn rand::Rng) -> AuxiliaryPath {
        AuxiliaryPath { path: self.sample(medium, rng), auxiliary: f64::NAN }
    }

    /// The claims of this sampler in this medium. Provided: that it is exact and needs a bounding majorant.
    fn claims<'a>(&'a self, _truth: &'a dyn Medium) -> FreePathClaims<'a> {
        FreePathClaims::default()
    }

    /// Its capabilities, for planted faults that need them: a fault is refused over a sampler that does not state what the
    /// fault lays hold of. Provided: nothing.
    fn capabilities(&self) -> Vec<Capability> {
        Vec::new()
    }

    /// Refuses a medium that the sampler cannot work in.
    ///
    /// # Errors
    /// Naming the parameter that does not fit the medium.
    fn accepts(&self, _medium: &dyn Extinction) -> Result<(), ParameterError> {
        Ok(())
    }
}

impl<F: Fn(&dyn Extinction, &mut dyn rand::Rng) -> f64 + Send + Sync> FreePathSampler for F {
    fn sample(&self, medium: &dyn Extinction, rng: &mut dyn rand::Rng) -> FreePath {
        FreePath::at(self(medium, rng))
    }
}

crate::list! {
    /// Every free-path sampler that a case can name.
    pub enum AnyFreePath: dyn FreePathSampler {
        delta_tracking::DeltaTracking,
        ray_marching::RayMarching,
        regular_tracking::RegularTracking,
    }
}

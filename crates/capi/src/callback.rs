//! A callback as a sampler and as an estimator.

use super::medium::fp_medium;
use super::rng::fp_rng;
use freepath_estimators::claims::{FreePathClaims, TransmittanceClaims};
use freepath_estimators::{Extinction, FreePath, FreePathSampler, Medium, TransmittanceEstimator};
use rand::Rng;
use std::ffi::c_void;
use std::panic::resume_unwind;

/// A function of C with its own data.
#[derive(Clone, Copy)]
pub(crate) struct Callback {
    pub(crate) draw: unsafe extern "C" fn(*mut c_void, *const fp_medium, *mut fp_rng) -> f64,
    pub(crate) user: *mut c_void,
    /// True if it says that no look-up exceeds the majorant.
    pub(crate) bounded: bool,
}

// SAFETY: unless its owner asks for threads, and promises by that to be ready for them, one thread alone calls it.
unsafe impl Send for Callback {}
// SAFETY: as above.
unsafe impl Sync for Callback {}

impl Callback {
    fn call(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> f64 {
        let (medium, mut rng) = (fp_medium::new(medium), fp_rng::new(rng));
        // SAFETY: both pointers are valid during the call, and whoever registered the callback answers for it and for `user`.
        let number = unsafe { (self.draw)(self.user, &raw const medium, &raw mut rng) };
        match rng.thrown().or_else(|| medium.thrown()) {
            Some(payload) => resume_unwind(payload),
            None => number,
        }
    }
}

impl FreePathSampler for Callback {
    fn sample(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
        FreePath::at(self.call(medium, rng))
    }
    fn claims<'a>(&'a self, _: &'a dyn Medium) -> FreePathClaims<'a> {
        FreePathClaims { bounded: self.bounded, ..FreePathClaims::default() }
    }
}

impl TransmittanceEstimator for Callback {
    fn estimate(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> f64 {
        self.call(medium, rng)
    }
    fn claims(&self, _: &dyn Medium) -> TransmittanceClaims {
        TransmittanceClaims { bounded: self.bounded, ..TransmittanceClaims::default() }
    }
}

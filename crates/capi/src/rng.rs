//! The uniforms of a callback.

use rand::{Rng, RngExt};
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Random numbers. Every draw must take its own from here, or a replay and the scripted streams cannot work.
pub struct fp_rng<'a> {
    inner: &'a mut dyn Rng,
    thrown: Option<Box<dyn Any + Send>>,
}

impl<'a> fp_rng<'a> {
    pub(crate) fn new(inner: &'a mut dyn Rng) -> Self {
        Self { inner, thrown: None }
    }

    pub(crate) fn thrown(self) -> Option<Box<dyn Any + Send>> {
        self.thrown
    }

    fn guarded<T>(&mut self, draw: impl FnOnce(&mut dyn Rng) -> T, last: T) -> T {
        if self.thrown.is_some() {
            return last;
        }
        match catch_unwind(AssertUnwindSafe(|| draw(self.inner))) {
            Ok(number) => number,
            Err(payload) => {
                self.thrown = Some(payload);
                last
            }
        }
    }
}

/// A uniform number in [0, 1), a multiple of 2^-53. Past the budget of a block it is 1 - 2^-53 for ever, so that walks
/// leave. NaN for a null generator.
///
/// # Safety
/// `rng` is null or came with the callback that runs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fp_uniform(rng: *mut fp_rng) -> f64 {
    // SAFETY: the caller's promise.
    unsafe { rng.as_mut() }.map_or(f64::NAN, |rng| rng.guarded(|rng| rng.random(), 1.0f64.next_down()))
}

/// 64 random bits. Past the budget of a block all are set; 0 for a null generator.
///
/// # Safety
/// As for `fp_uniform`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fp_word(rng: *mut fp_rng) -> u64 {
    // SAFETY: the caller's promise.
    unsafe { rng.as_mut() }.map_or(0, |rng| rng.guarded(|rng| rng.next_u64(), u64::MAX))
}

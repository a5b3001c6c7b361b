//! The medium as a callback sees it.

use freepath_estimators::Extinction;
use std::any::Any;
use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// The medium along a ray. Every look-up is counted and held against the majorant.
pub struct fp_medium<'a> {
    inner: &'a dyn Extinction,
    /// The payload of a look-up's panic: it must not cross the callback, and is thrown again behind it.
    thrown: Cell<Option<Box<dyn Any + Send>>>,
}

impl<'a> fp_medium<'a> {
    pub(crate) fn new(inner: &'a dyn Extinction) -> Self {
        Self { inner, thrown: Cell::new(None) }
    }

    /// The payload of a panic during the callback.
    pub(crate) fn thrown(&self) -> Option<Box<dyn Any + Send>> {
        self.thrown.take()
    }

    /// NaN if the look-up panics: every walk must leave on NaN.
    fn guarded(&self, look: impl FnOnce(&dyn Extinction) -> f64) -> f64 {
        catch_unwind(AssertUnwindSafe(|| look(self.inner))).unwrap_or_else(|payload| {
            self.thrown.set(Some(payload));
            f64::NAN
        })
    }
}

/// `look` at a medium that may be null: then NaN.
///
/// # Safety
/// `medium` is null or came with the callback that runs.
unsafe fn look(medium: *const fp_medium, look: impl FnOnce(&dyn Extinction) -> f64) -> f64 {
    // SAFETY: the caller's promise.
    unsafe { medium.as_ref() }.map_or(f64::NAN, |medium| medium.guarded(look))
}

/// The extinction at distance `t`, 1/length. NaN past the budget of look-ups, and for a null medium.
///
/// # Safety
/// `medium` is null or came with the callback that runs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fp_mu(medium: *const fp_medium, t: f64) -> f64 {
    // SAFETY: the caller's promise.
    unsafe { look(medium, |medium| medium.mu(t)) }
}

/// The length of the ray. NaN for a null medium.
///
/// # Safety
/// As for `fp_mu`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fp_length(medium: *const fp_medium) -> f64 {
    // SAFETY: the caller's promise.
    unsafe { look(medium, |medium| medium.length()) }
}

/// The majorant at distance `t`, 1/length: an upper bound of the extinction on its segment. NaN for a null medium.
///
/// # Safety
/// As for `fp_mu`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fp_majorant(medium: *const fp_medium, t: f64) -> f64 {
    // SAFETY: the caller's promise.
    unsafe { look(medium, |medium| medium.majorants().mu_bar_at(t)) }
}

/// The number of majorant segments of the ray, at least 1; 0 for a null medium.
///
/// # Safety
/// As for `fp_mu`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fp_segments(medium: *const fp_medium) -> usize {
    // SAFETY: the caller's promise.
    unsafe { medium.as_ref() }.map_or(0, |medium| medium.inner.majorants().ends().len())
}

/// The end of majorant segment `i`; that of the last is the length. NaN if there is no such segment.
///
/// # Safety
/// As for `fp_mu`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fp_segment_end(medium: *const fp_medium, i: usize) -> f64 {
    // SAFETY: the caller's promise.
    unsafe { look(medium, |medium| medium.majorants().ends().get(i).copied().unwrap_or(f64::NAN)) }
}

/// The majorant on segment `i`, 1/length. NaN if there is no such segment.
///
/// # Safety
/// As for `fp_mu`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fp_segment_majorant(medium: *const fp_medium, i: usize) -> f64 {
    // SAFETY: the caller's promise.
    unsafe { look(medium, |medium| medium.majorants().mu_bar().get(i).copied().unwrap_or(f64::NAN)) }
}

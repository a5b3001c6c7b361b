//! freepath from C: a callback draws, the harness looks up the medium for it, hands it uniforms, and judges.
//!
//! The header `include/freepath.h` is made from this file and is its documentation.
#![allow(unsafe_code, reason = "the border to C is made of pointers")]
#![allow(non_camel_case_types, reason = "the names of the header")]

#[cfg(test)]
mod border;
mod callback;
mod check;
mod medium;
mod message;
mod rng;

pub use check::{fp_check_free_path, fp_check_transmittance, fp_default_options, fp_options, fp_verdict};
pub use medium::{fp_length, fp_majorant, fp_medium, fp_mu, fp_segment_end, fp_segment_majorant, fp_segments};
pub use rng::{fp_rng, fp_uniform, fp_word};

/// Draws one number: a free path (infinity for an escape), or an estimate of the transmittance.
///
/// It must not throw (`fp_caught` makes NaN of an exception), and must not keep `medium` or `rng` after it returns. `user` is what was handed to the check.
pub type fp_sample =
    Option<unsafe extern "C" fn(user: *mut std::ffi::c_void, medium: *const fp_medium, rng: *mut fp_rng) -> f64>;

//! Tests of what crosses the border and what must not.
#![allow(unsafe_code, reason = "the tests are the caller from C")]
#![allow(clippy::disallowed_methods, reason = "as a caller would write it")]

use super::{
    fp_check_free_path, fp_check_transmittance, fp_default_options, fp_length, fp_majorant, fp_medium, fp_mu,
    fp_options, fp_rng, fp_sample, fp_segment_end, fp_segments, fp_uniform, fp_verdict, fp_word,
};
use std::ffi::{CStr, CString, c_void};
use std::ptr::{null, null_mut};

const MEDIUM: &str = r#"{"gaussian": {"peak": 4.0, "center": 0.9, "width": 0.25, "length": 2.0, "base": 0.2}}"#;

fn options() -> fp_options {
    fp_options { draws: 40_000, ..fp_default_options() }
}

fn judged(medium: &str, sample: fp_sample, options: &fp_options) -> (fp_verdict, String) {
    let (medium, mut message) = (CString::new(medium).unwrap(), [1; 4000]);
    // SAFETY: every pointer is valid.
    let verdict = unsafe {
        fp_check_free_path(medium.as_ptr(), sample, null_mut(), options, message.as_mut_ptr(), message.len())
    };
    // SAFETY: a message is always ended.
    let text = unsafe { CStr::from_ptr(message.as_ptr()) };
    (verdict, text.to_str().unwrap().to_string())
}

unsafe extern "C" fn tracker(_: *mut c_void, medium: *const fp_medium, rng: *mut fp_rng) -> f64 {
    // SAFETY: both came with the callback.
    unsafe {
        let mut t = 0.0;
        loop {
            t -= (-fp_uniform(rng)).ln_1p() / fp_majorant(medium, t);
            if !(t < fp_length(medium)) {
                return f64::INFINITY;
            }
            if fp_uniform(rng) * fp_majorant(medium, t) < fp_mu(medium, t) {
                return t;
            }
        }
    }
}

unsafe extern "C" fn nan(_: *mut c_void, _: *const fp_medium, _: *mut fp_rng) -> f64 {
    f64::NAN
}

unsafe extern "C" fn endless(_: *mut c_void, medium: *const fp_medium, rng: *mut fp_rng) -> f64 {
    // SAFETY: both came with the callback.
    unsafe { while fp_uniform(rng) < 0.99 && fp_mu(medium, 0.1) >= 0.0 {} }
    // SAFETY: as above.
    unsafe { while fp_uniform(rng) < 0.999_999_999 {} }
    0.5
}

unsafe extern "C" fn beyond(_: *mut c_void, medium: *const fp_medium, rng: *mut fp_rng) -> f64 {
    // SAFETY: both came with the callback.
    unsafe { 1.01 * fp_length(medium) * fp_uniform(rng) }
}

#[test]
fn a_right_sampler_passes_on_any_number_of_threads() {
    let one = judged(MEDIUM, Some(tracker), &options());
    assert_eq!(one.0, fp_verdict::FP_PASS, "{}", one.1);
    let four = judged(MEDIUM, Some(tracker), &fp_options { threads: 4, ..options() });
    assert_eq!(one, four);
}

#[test]
fn look_ups_are_held_against_the_majorant() {
    unsafe extern "C" fn outside(_: *mut c_void, medium: *const fp_medium, rng: *mut fp_rng) -> f64 {
        // SAFETY: both came with the callback.
        unsafe {
            let _ = fp_mu(medium, -0.25);
            tracker(null_mut(), medium, rng)
        }
    }
    let (verdict, text) = judged(MEDIUM, Some(outside), &options());
    assert_eq!(verdict, fp_verdict::FP_FAIL);
    assert!(text.contains("out_of_support") && text.contains("look-ups lie outside the ray"), "{text}");
}

#[test]
fn nan_and_collisions_beyond_the_ray_are_verdicts() {
    let (verdict, text) = judged(MEDIUM, Some(nan), &options());
    assert_eq!(verdict, fp_verdict::FP_FAIL);
    assert!(text.contains("non_finite"), "{text}");
    let (verdict, text) = judged(MEDIUM, Some(beyond), &options());
    assert_eq!(verdict, fp_verdict::FP_FAIL);
    assert!(text.contains("out_of_support"), "{text}");
}

#[test]
fn a_callback_that_looks_nothing_up_is_judged_by_its_draws() {
    const SLAB: &str = r#"{"constant": {"mu": 1.5, "length": 2.0}}"#;
    unsafe extern "C" fn known(user: *mut c_void, _: *const fp_medium, rng: *mut fp_rng) -> f64 {
        // SAFETY: it came with the callback.
        let t = -(-unsafe { fp_uniform(rng) }).ln_1p() / if user.is_null() { 1.5 } else { 1.4 };
        if t < 2.0 { t } else { f64::INFINITY }
    }
    unsafe extern "C" fn fixed(_: *mut c_void, _: *const fp_medium, _: *mut fp_rng) -> f64 {
        0.5
    }
    unsafe extern "C" fn escapes(_: *mut c_void, _: *const fp_medium, _: *mut fp_rng) -> f64 {
        f64::INFINITY
    }
    unsafe extern "C" fn negative(_: *mut c_void, _: *const fp_medium, rng: *mut fp_rng) -> f64 {
        // SAFETY: it came with the callback.
        -1e-3 - unsafe { fp_uniform(rng) }
    }
    assert_eq!(judged(SLAB, Some(known), &options()).0, fp_verdict::FP_PASS);
    let samplers: [(fp_sample, &str); 3] =
        [(Some(fixed), "dependent"), (Some(escapes), "wrong_law"), (Some(negative), "out_of_support")];
    for (sample, reason) in samplers {
        let (verdict, text) = judged(SLAB, sample, &options());
        assert!(verdict == fp_verdict::FP_FAIL && text.contains(reason), "{reason}: {text}");
    }
}

#[test]
fn an_infinite_estimate_is_a_verdict() {
    let (medium, mut message) = (CString::new(MEDIUM).unwrap(), [1; 4000]);
    let sample: fp_sample = Some(infinite);
    unsafe extern "C" fn infinite(_: *mut c_void, _: *const fp_medium, _: *mut fp_rng) -> f64 {
        f64::INFINITY
    }
    // SAFETY: every pointer is valid.
    let verdict = unsafe {
        fp_check_transmittance(
            medium.as_ptr(),
            sample,
            null_mut(),
            &options(),
            message.as_mut_ptr(),
            message.len(),
        )
    };
    // SAFETY: a message is always ended.
    let text = unsafe { CStr::from_ptr(message.as_ptr()) }.to_str().unwrap();
    assert!(verdict == fp_verdict::FP_FAIL && text.contains("non_finite"), "{text}");
}

#[test]
fn a_callback_that_goes_on_for_ever_is_stopped_by_its_budget() {
    let (verdict, text) = judged(MEDIUM, Some(endless), &fp_options { draws: 1, ..options() });
    assert_eq!(verdict, fp_verdict::FP_FAIL);
    assert!(text.contains("subject_error") && text.contains("budget"), "{text}");
}

#[test]
fn null_pointers_are_told_and_not_followed() {
    let unusable = |found: (fp_verdict, String), words: &str| {
        assert_eq!(found.0, fp_verdict::FP_UNUSABLE);
        assert!(found.1.contains(words), "{}", found.1);
    };
    unusable(judged(MEDIUM, None, &options()), "the callback is null");
    // SAFETY: null is allowed everywhere.
    let verdict = unsafe { fp_check_free_path(null(), Some(tracker), null_mut(), null(), null_mut(), 0) };
    assert_eq!(verdict, fp_verdict::FP_UNUSABLE);
    // SAFETY: as above.
    let (mu, segments, end, uniform, word) = unsafe {
        (
            fp_mu(null(), 0.0),
            fp_segments(null()),
            fp_segment_end(null(), 0),
            fp_uniform(null_mut()),
            fp_word(null_mut()),
        )
    };
    assert!(mu.is_nan() && end.is_nan() && uniform.is_nan() && segments == 0 && word == 0);
}

#[test]
fn what_cannot_be_used_is_said() {
    let unusable = |medium: &str, options: fp_options, words: &str| {
        let (verdict, text) = judged(medium, Some(tracker), &options);
        assert_eq!(verdict, fp_verdict::FP_UNUSABLE);
        assert!(text.contains(words), "{text}");
    };
    unusable("{", options(), "medium");
    unusable(r#"{"gausian": {}}"#, options(), "gaussian");
    unusable(&MEDIUM.replace("4.0", "-4"), options(), "peak must be finite and not negative, not -4");
    let channels = r#"{"chromatic": {"sigma_t": [2.0, 0.5], "sigma_s": [1.5, 0.5], "length": 3.0}}"#;
    unusable(channels, options(), "needs one extinction (not the medium `chromatic`)");
    unusable(MEDIUM, fp_options { draws: 0, ..options() }, "draws must be 1 to 1e12");
    unusable(MEDIUM, fp_options { tolerance: f64::NAN, ..options() }, "tolerance must be 0 to 1");
    unusable(MEDIUM, fp_options { resolution_bits: 7, ..options() }, "resolution_bits must be 8 to 53");
    for threads in [0, 1025, u32::MAX] {
        unusable(MEDIUM, fp_options { threads, ..options() }, "threads must be 1 to 1024");
    }
}

#[test]
fn a_message_is_cut_and_always_ended() {
    let (medium, mut message) = (CString::new(MEDIUM).unwrap(), [1; 8]);
    // SAFETY: every pointer is valid.
    unsafe {
        fp_check_transmittance(medium.as_ptr(), None, null_mut(), null(), message.as_mut_ptr(), message.len())
    };
    // SAFETY: a message is always ended.
    assert_eq!(unsafe { CStr::from_ptr(message.as_ptr()) }.to_str(), Ok("the cal"));
}

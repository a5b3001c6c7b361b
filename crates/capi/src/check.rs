//! The verdict on a callback.

use super::callback::Callback;
use super::fp_sample;
use super::message::{get, put};
use freepath::{Effort, verify};
use freepath_harness::case::{CaseFile, Limits};
use freepath_harness::experiment::Experiment;
use freepath_harness::kind::{FreePathKind, InScene, Ray, Transmittance};
use freepath_harness::scene::MediumScene;
use freepath_harness::subject::Subject;
use freepath_results::Verdict;
use std::any::Any;
use std::ffi::{c_char, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

/// The verdict of a check. The numbers are those of the command's exit codes.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum fp_verdict {
    /// No claim is rejected.
    FP_PASS = 0,
    /// A claim is rejected; a wrong alarm has a probability of at most 1e-6.
    FP_FAIL = 1,
    /// The arguments cannot be used; the message says which and why.
    FP_UNUSABLE = 2,
    /// The draws do not tell; the message says why.
    FP_INCONCLUSIVE = 4,
}

/// Effort and claims of a check. Take `fp_default_options()` and change what is to be changed.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fp_options {
    /// The seed of all uniforms; 1 by default.
    pub seed: u64,
    /// Draws of the first stage, rounded up to blocks of 16,384; 131,072 by default. A suspect gets twice as many fresh ones.
    pub draws: u64,
    /// The most by which any claim may be off, 6e-8 for a sampler in single precision; 0 by default.
    pub tolerance: f64,
    /// Bits of the uniforms that the sampler makes of its own, 24 for single precision; 53 by default.
    pub resolution_bits: u32,
    /// Threads that may call the callback at a time, at most 1024; 1 by default. The verdict does not depend on it.
    pub threads: u32,
    /// True if the callback claims no look-up above the majorant, as delta tracking must and ratio tracking need not;
    /// true by default.
    pub bounded: bool,
}

/// The options that are used where none are given.
#[unsafe(no_mangle)]
pub extern "C" fn fp_default_options() -> fp_options {
    fp_options { seed: 1, draws: 1 << 17, tolerance: 0.0, resolution_bits: 53, threads: 1, bounded: true }
}

/// Judges free paths: `sample` returns the distance of a collision, or infinity for an escape.
///
/// `medium` is the medium of a case file in JSON, such as `{"gaussian": {"peak": 4, "center": 0.9, "width": 0.25,
/// "length": 2}}`; files that it names are relative to the working folder. `options` may be null. `message` gets at most
/// `capacity` bytes of text that always ends with a zero, and may be null.
///
/// # Safety
/// Every pointer is null or valid; `sample` and `user` are ready for as many threads as the options allow.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fp_check_free_path(
    medium: *const c_char,
    sample: fp_sample,
    user: *mut c_void,
    options: *const fp_options,
    message: *mut c_char,
    capacity: usize,
) -> fp_verdict {
    // SAFETY: the caller's promise.
    unsafe {
        check(medium, sample, user, options, (message, capacity), |callback, ray| {
            Box::new(InScene::<FreePathKind>::of(callback, ray))
        })
    }
}

/// Judges a transmittance estimator: `sample` returns an estimate of exp(-tau(length)). See `fp_check_free_path`.
///
/// # Safety
/// As for `fp_check_free_path`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fp_check_transmittance(
    medium: *const c_char,
    sample: fp_sample,
    user: *mut c_void,
    options: *const fp_options,
    message: *mut c_char,
    capacity: usize,
) -> fp_verdict {
    // SAFETY: the caller's promise.
    unsafe {
        check(medium, sample, user, options, (message, capacity), |callback, ray| {
            Box::new(InScene::<Transmittance>::of(callback, ray))
        })
    }
}

/// A callback in its medium, as a subject of one kind.
type ExperimentOf = for<'a> fn(&'a Callback, Ray<'a>) -> Box<dyn Experiment + 'a>;

/// # Safety
/// As for `fp_check_free_path`.
unsafe fn check(
    medium: *const c_char,
    sample: fp_sample,
    user: *mut c_void,
    options: *const fp_options,
    (message, capacity): (*mut c_char, usize),
    experiment: ExperimentOf,
) -> fp_verdict {
    // SAFETY: the caller's promise.
    let (medium, options) = unsafe { (get(medium), options.as_ref().copied()) };
    let options = options.unwrap_or_else(|| fp_default_options());
    let judged = catch_unwind(AssertUnwindSafe(|| {
        let draw = sample.ok_or("the callback is null")?;
        let medium = medium.ok_or("the medium is null or not UTF-8")?;
        judge(medium, &Callback { draw, user, bounded: options.bounded }, &options, experiment)
    }));
    let (verdict, text) = match judged {
        Ok(Ok(judged)) => judged,
        Ok(Err(why)) => (fp_verdict::FP_UNUSABLE, why),
        Err(payload) => (fp_verdict::FP_UNUSABLE, format!("the harness panicked: {}", words(payload.as_ref()))),
    };
    // SAFETY: the caller's promise.
    unsafe { put(&text, message, capacity) };
    verdict
}

fn words(payload: &(dyn Any + Send)) -> String {
    let text = payload.downcast_ref::<&str>().map(ToString::to_string);
    text.or_else(|| payload.downcast_ref::<String>().cloned()).unwrap_or_default()
}

fn judge(
    medium: &str,
    callback: &Callback,
    options: &fp_options,
    experiment: ExperimentOf,
) -> Result<(fp_verdict, String), String> {
    require(options.draws >= 1 && options.draws <= 1_000_000_000_000, "draws", "1 to 1e12")?;
    require(options.tolerance >= 0.0 && options.tolerance <= 1.0, "tolerance", "0 to 1")?;
    require((8..=53).contains(&options.resolution_bits), "resolution_bits", "8 to 53")?;
    require((1..=1024).contains(&options.threads), "threads", "1 to 1024")?;
    let text = format!(
        r#"{{ "title": "C", "medium": {medium}, "subjects": [ {{ "free_path": {{ "exact": {{}} }} }} ] }}"#
    );
    let case = CaseFile::parse(Path::new("medium"), text).and_then(|case| case.prepare(&Limits::default()));
    let cases = case.map_err(|why| why.render(false))?;
    let scene = cases.first().and_then(|case| case.scene.get());
    let Some(MediumScene(medium)) = scene else {
        return Err("a medium with channels cannot be sampled by one callback".into());
    };
    let experiment = experiment(callback, Ray::of(medium));
    let subject =
        Subject { tolerance: options.tolerance, bits: options.resolution_bits, ..Subject::new(&*experiment) };
    let effort = Effort { seed: options.seed, draws: options.draws };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(options.threads as usize);
    let pool = pool.build().map_err(|why| format!("cannot start threads: {why}"))?;
    let (verdict, text) = pool.install(|| verify(&subject, effort));
    let verdict = match verdict {
        Verdict::Pass => fp_verdict::FP_PASS,
        Verdict::Fail => fp_verdict::FP_FAIL,
        Verdict::Inconclusive => fp_verdict::FP_INCONCLUSIVE,
    };
    Ok((verdict, text))
}

fn require(holds: bool, name: &str, allowed: &str) -> Result<(), String> {
    if holds { Ok(()) } else { Err(format!("{name} must be {allowed}")) }
}

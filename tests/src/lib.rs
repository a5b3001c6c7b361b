//! Parts of the proofs: the shipped cases, and a run of them.

pub mod tools;

use freepath_estimators::medium::ChromaticMedium;
use freepath_estimators::{ChromaticSampler, FreePathSampler, TransmittanceEstimator};
use freepath_harness::case::{CaseFile, Limits, Prepared};
use freepath_harness::collect::{Stopped, Watch, observe};
use freepath_harness::kind::{Chromatic, FreePathKind, InScene, Ray, Transmittance};
use freepath_harness::run::{Options, run};
use freepath_harness::subject::Subject;
use freepath_results::Results;
use freepath_statistics::Judged;
use freepath_statistics::decide::{Decision, adjust, decide, suspect};
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

/// The root of the repository.
#[must_use]
pub fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

/// Every case file under `folder` of the repository, sorted.
#[must_use]
pub fn case_paths(folder: &str) -> Vec<PathBuf> {
    let mut paths = Vec::new();
    let mut folders = vec![root().join(folder)];
    while let Some(folder) = folders.pop() {
        let entries = std::fs::read_dir(&folder).expect("the folder of cases is there");
        for path in entries.filter_map(Result::ok).map(|entry| entry.path()) {
            match path.extension() {
                None => folders.push(path),
                Some(extension) if extension == "json" => paths.push(path),
                Some(_) => {}
            }
        }
    }
    paths.sort();
    paths
}

/// The case at `path`, prepared.
///
/// # Panics
/// If it cannot be used.
#[must_use]
pub fn load(path: &Path, limits: &Limits) -> Vec<Prepared> {
    let file = CaseFile::load(path).unwrap_or_else(|error| panic!("{error}"));
    file.prepare(limits).unwrap_or_else(|error| panic!("{error}"))
}

/// A case given as text, prepared.
///
/// # Panics
/// If it cannot be used.
#[must_use]
pub fn parse(text: &str) -> Vec<Prepared> {
    let file = CaseFile::parse(Path::new("case.json"), text).unwrap_or_else(|error| panic!("{error}"));
    file.prepare(&Limits::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// The results of `cases` under `seed`.
///
/// # Panics
/// Never: nobody cancels.
#[must_use]
pub fn results(cases: &[Prepared], seed: u64) -> Results {
    let cancelled = AtomicBool::new(false);
    let options = Options { seed, cancelled: &cancelled, progress: &|_, _| (), repro: String::new() };
    run(cases, &options).unwrap_or_else(|_| panic!("nobody cancels")).results
}

/// One line for each result that is not as expected.
#[must_use]
pub fn surprises(results: &Results) -> Vec<String> {
    let wrong = results.results.iter().filter(|result| !result.as_expected);
    wrong
        .map(|r| {
            format!("{}: {} {:?} where {} is expected: {:?}", r.id, r.verdict, r.reasons, r.expected, r.notes)
        })
        .collect()
}

/// Both stages of one subject, decided alone.
pub struct Judgement {
    /// The decision.
    pub decision: Decision,
    /// Stage 1, and stage 2 if it was needed.
    pub stages: Vec<Judged>,
}

impl Judgement {
    /// The p-value of a test in stage 1: none if it was withheld or not made.
    #[must_use]
    pub fn p(&self, test: &str) -> Option<f64> {
        self.stages[0].evidence.iter().find(|evidence| evidence.name == test)?.p
    }
}

/// A free-path sampler along a ray.
pub fn free_path<'a>(sampler: &'a dyn FreePathSampler, ray: Ray<'a>) -> InScene<'a, FreePathKind> {
    InScene::of(sampler, ray)
}

/// A transmittance estimator along a ray.
pub fn transmittance<'a>(estimator: &'a dyn TransmittanceEstimator, ray: Ray<'a>) -> InScene<'a, Transmittance> {
    InScene::of(estimator, ray)
}

/// A chromatic sampler in its channels.
pub fn chromatic<'a>(sampler: &'a dyn ChromaticSampler, medium: &'a ChromaticMedium) -> InScene<'a, Chromatic> {
    InScene::of(sampler, medium)
}

/// `subject` through both stages.
///
/// # Panics
/// Never: nobody cancels.
#[must_use]
pub fn judgement(subject: &Subject, seed: u64) -> Judgement {
    let (plan, never) = (subject.plan(), AtomicBool::new(false));
    let watch = Watch { cancelled: &never, progress: &|_| () };
    let stage = |blocks| match observe(subject, &plan, seed, blocks, &watch) {
        Ok(seen) => plan.claims.judge(&seen.tallies),
        Err(Stopped::Subject(why)) => Judged::broken(why),
        Err(Stopped::Cancelled) => panic!("nobody cancels"),
    };
    let blocks = Subject::blocks(subject.draws);
    let mut stages = vec![stage(0..blocks)];
    if suspect(&stages[0]) {
        stages.push(stage(blocks..3 * blocks));
    }
    let alone: Vec<_> = stages.iter().flat_map(|judged| adjust([judged].into_iter())).collect();
    let decision = decide(&alone[0], alone.get(1));
    Judgement { decision, stages }
}

/// Says which tests of the workspace are left out for want of a tool, in the last lines of `cargo test`.
///
/// Those lines belong to the examples of documentation, of which this is the last, and what an example prints is kept back if
/// it passes. So it is written to where the program that runs the examples writes its own messages, if the system shows that.
///
/// ```standalone_crate
/// freepath_tests::say_what_is_left_out();
/// ```
pub fn say_what_is_left_out() {
    let lines: String = tools::left_out().into_iter().map(|line| line + "\n").collect();
    if lines.is_empty() {
        return;
    }
    let beyond = format!("/proc/{}/fd/2", parent());
    let appended = std::fs::OpenOptions::new().append(true).open(beyond);
    if !appended.is_ok_and(|mut out| std::io::Write::write_all(&mut out, format!("\n{lines}").as_bytes()).is_ok())
    {
        eprint!("{lines}");
    }
}

#[cfg(unix)]
fn parent() -> u32 {
    std::os::unix::process::parent_id()
}

#[cfg(not(unix))]
fn parent() -> u32 {
    0
}

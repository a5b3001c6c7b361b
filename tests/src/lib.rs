//! What the proofs share: the shipped cases, and a run of them.

use freepath_harness::case::{CaseFile, Limits, Prepared};
use freepath_harness::results::Results;
use freepath_harness::run::{Options, run};
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
    file.prepare(&Limits::default())
        .unwrap_or_else(|error| panic!("{error}"))
}

/// The results of `cases` under `seed`.
///
/// # Panics
/// Never: nobody cancels.
#[must_use]
pub fn results(cases: &[Prepared], seed: u64) -> Results {
    let cancelled = AtomicBool::new(false);
    let options = Options {
        seed,
        cancelled: &cancelled,
        progress: &|_, _| (),
        repro: String::new(),
    };
    run(cases, &options)
        .unwrap_or_else(|_| panic!("nobody cancels"))
        .results
}

/// One line for each result that is not as expected.
#[must_use]
pub fn surprises(results: &Results) -> Vec<String> {
    let wrong = results.results.iter().filter(|result| !result.as_expected);
    wrong
        .map(|r| {
            format!(
                "{}: {} {:?} where {} is expected: {:?}",
                r.id, r.verdict, r.reasons, r.expected, r.notes
            )
        })
        .collect()
}

//! A case file, judged from Rust.

use freepath_draws::simd;
use freepath_harness::case::{CaseFile, Limits};
use freepath_harness::run::{Cancelled, Options, quoted, run};
use freepath_results::Results;
use std::path::Path;
use std::sync::atomic::AtomicBool;

/// The results of a case file, as the command `freepath run` has them: every subject through both stages, one decision over all.
///
/// The same `seed` gives the same draws. Programs that a case names are not started.
///
/// ```
/// use freepath::{Verdict, check};
///
/// # let folder = std::env::temp_dir().join("freepath_check");
/// # std::fs::create_dir_all(&folder)?;
/// let case = folder.join("fog.json");
/// std::fs::write(&case, r#"{
///     "title": "Fog",
///     "medium": { "constant": { "mu": 1.5, "length": 2.0 } },
///     "subjects": [ { "free_path": { "delta_tracking": {} } } ],
///     "draws": 65536
/// }"#)?;
/// let results = check(&case, 1)?;
/// assert_eq!(results.results[0].verdict, Verdict::Pass);
/// // With the feature `report`: freepath::report::write(&results, None, &folder.join("report"))?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If the file cannot be read, or does not say what is to be judged: file, line, column, and what is allowed.
pub fn check(case: &Path, seed: u64) -> Result<Results, String> {
    simd::check_environment().map_err(|why| why.to_string())?;
    let prepared = CaseFile::load(case).and_then(|file| file.prepare(&Limits::default()));
    let prepared = prepared.map_err(|why| why.render(false))?;
    let cancelled = AtomicBool::new(false);
    let repro = format!("freepath run {} --seed {seed}", quoted(&case.display().to_string()));
    let outcome = run(&prepared, &Options { seed, cancelled: &cancelled, progress: &|_, _| (), repro });
    outcome.map(|outcome| outcome.results).map_err(|Cancelled| "the run was cancelled, by nobody".into())
}

//! Whole cases: read, prepared, one block of draws of a subject judged, and the results of a run.

use super::case::{WORDS, shipped};
use super::{PLAIN, Target};
use crate::judge::{Answer, Bounds};
use freepath_harness::case::{CaseFile, Limits, Prepared};
use freepath_harness::collect::{Stopped, Watch, observe};
use freepath_harness::run::{self, Options};
use freepath_statistics::Detection;
use serde_json::Value;
use std::path::Path;
use std::sync::atomic::AtomicBool;

/// A shipped case with one subject, its parameters changed.
pub(super) const RUN: Target = Target {
    name: "run",
    about: "a whole case: read, prepared, drawn and judged",
    seeds,
    words: WORDS,
    tree: true,
    reader: |_| Box::new(whole),
    bounds: Bounds { seconds: 20.0, bytes: 512 << 20, per_byte: 4096, hang: 240.0 },
    quick: 100,
    ..PLAIN
};

/// Draws of the block.
const DRAWS: u64 = 256;

/// A case with each of its subjects alone.
fn seeds() -> Vec<Vec<u8>> {
    let mut seeds = Vec::new();
    for (path, text) in shipped() {
        let Ok(file) = CaseFile::parse(&path, text) else { continue };
        let mut case = file.case;
        for subject in std::mem::take(&mut case.subjects) {
            case.subjects = vec![subject];
            seeds.extend(serde_json::to_vec(&case));
        }
    }
    seeds
}

fn whole(input: &[u8]) -> Answer {
    let text = std::str::from_utf8(input).map_err(|why| why.to_string())?;
    modest(text)?;
    let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../cases/fuzz.json"));
    let limits = Limits { draws: Some(DRAWS), ..Limits::default() };
    let mut file = CaseFile::parse(path, text).map_err(|why| why.render(false))?;
    for budget in file.case.subjects.iter_mut().map(|subject| &mut subject.budget).chain([&mut file.case.budget]) {
        *budget = Some(DRAWS);
    }
    let mut cases = file.prepare(&limits).map_err(|why| why.render(false))?;
    cases.truncate(1);
    cases.iter_mut().for_each(|case| case.subjects.truncate(2));
    let lookups = cases.iter().map(block).collect::<Result<Vec<_>, _>>()?;
    if lookups.iter().all(|&lookups| lookups < 100.0) { run(&cases) } else { Ok(()) }
}

/// Work that is allowed, up to 1e8 steps or segments, is not asked for: it is long, and no fault.
fn modest(text: &str) -> Answer {
    fn much(value: &Value) -> bool {
        let effort = |key: &str, value: &Value| {
            matches!(key, "steps" | "segments") && value.as_f64().is_some_and(|n| n > 1e4 && n <= 1e8)
        };
        match value {
            Value::Array(items) => items.iter().any(much),
            Value::Object(members) => members.iter().any(|(key, value)| effort(key, value) || much(value)),
            Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => false,
        }
    }
    match serde_json::from_str(text) {
        Ok(value) if much(&value) => Err("more work than is fuzzed".into()),
        _ => Ok(()),
    }
}

/// One short block of each subject, judged: the most look-ups of a draw.
fn block(case: &Prepared) -> Result<f64, String> {
    let never = AtomicBool::new(false);
    let watch = Watch { cancelled: &never, progress: &|_| () };
    let mut most = 0.0;
    for prepared in &case.subjects {
        let mut subject = prepared.runnable(&case.case);
        (subject.draws, subject.rows, subject.lookups_per_draw) = (DRAWS, DRAWS as usize, 20_000);
        let plan = subject.plan();
        match observe(&subject, &plan, 1, 0..1, &watch) {
            Ok(collected) => {
                let summary = plan.claims.summary(Some(&collected.tallies), Detection::alone(DRAWS));
                let lookups = summary.audit.lookups as f64 / DRAWS as f64;
                most = if lookups > most { lookups } else { most };
                drop(plan.claims.judge(&collected.tallies));
            }
            Err(Stopped::Subject(why)) => return Err(why),
            Err(Stopped::Cancelled) => return Err("nobody cancels".into()),
        }
    }
    Ok(most)
}

fn run(cases: &[Prepared]) -> Answer {
    let never = AtomicBool::new(false);
    let options = Options { seed: 1, cancelled: &never, progress: &|_, _| (), repro: String::new() };
    let outcome = run::run(cases, &options).map_err(|_| "nobody cancels")?;
    let text = freepath_report::json(&outcome.results).map_err(|why| why.to_string())?;
    serde_json::from_str::<freepath_results::Results>(&text).map(drop).map_err(|why| why.to_string())
}

//! results.json and what lies beside it, as `freepath report` reads them.

use super::{PLAIN, Target};
use crate::judge::{Answer, Bounds};
use freepath_harness::case::{CaseFile, Limits, Prepared};
use freepath_harness::run::{self, Options};
use freepath_harness::{power, soak};
use freepath_report::SideFiles;
use freepath_results::{PowerResults, Results, SoakResults, Timings};
use serde::de::DeserializeOwned;
use serde_json::{Value, json};
use std::path::Path;
use std::sync::atomic::AtomicBool;

/// The four files of a report, as members of one object.
pub(super) const REPORT: Target = Target {
    name: "report",
    about: "results.json, timings.json, power.json and soak.json, shown",
    seeds,
    words: &[
        "results",
        "timings",
        "power",
        "soak",
        "media",
        "series",
        "t",
        "mu",
        "edges",
        "expected",
        "p",
        "inf",
        "nan",
        "-inf",
        "tests",
        "name",
        "statistic",
        "pass",
        "fail",
        "verdict",
        "reasons",
        "rows",
        "levels",
        "id",
        "medium",
        "law",
        "mean",
        "rankings",
    ],
    tree: true,
    reader: |folder| {
        let folder = folder.to_path_buf();
        Box::new(move |input| show(input, &folder))
    },
    bounds: Bounds { seconds: 20.0, bytes: 256 << 20, per_byte: 4096, hang: 240.0 },
    quick: 100,
    ..PLAIN
};

/// Items of a list in a valid input: a report has hundreds of points, of which each is like the next.
const ITEMS: usize = 6;

/// One input in so many is drawn as a program would, PNG files and all.
const DRAWN: usize = 32;

fn show(input: &[u8], folder: &Path) -> Answer {
    let text = std::str::from_utf8(input).map_err(|why| why.to_string())?;
    let whole: Value = serde_json::from_str(text).map_err(|why| why.to_string())?;
    let results: Results = part(&whole, "results")?;
    let side_files = SideFiles {
        timings: part::<Timings>(&whole, "timings").ok(),
        power: part::<PowerResults>(&whole, "power").ok(),
        soak: part::<SoakResults>(&whole, "soak").ok(),
        ..SideFiles::default()
    };
    let options = freepath_report::Options { run: Some("run".into()), ..Default::default() };
    let page = options.html(&results, &side_files).map_err(|why| why.to_string())?;
    assert!(!page.contains("<svg onload"), "text of a file is markup");
    if input.len().is_multiple_of(DRAWN) {
        options.write(&results, &side_files, folder).map_err(|why| why.to_string())?;
    }
    Ok(())
}

fn part<T: DeserializeOwned>(whole: &Value, name: &str) -> Result<T, String> {
    serde_json::from_str(&whole[name].to_string()).map_err(|why| why.to_string())
}

const CASES: [&str; 2] = [
    r#"{
      "title": "grey", "draws": 1,
      "medium": { "gaussian": { "peak": 4.0, "center": 0.9, "width": 0.25, "length": 2.0 } },
      "majorant": { "segments": 3 },
      "subjects": [
        { "free_path": { "delta_tracking": {} } },
        { "free_path": { "delta_tracking": {} }, "fault": { "short_majorant": { "factor": 0.5 } }, "name": "short" },
        { "transmittance": { "ratio_tracking": {} }, "bias_bound": { "relative": 0.1 }, "budget": 1 },
        { "transmittance": { "residual_ratio_tracking": { "control": "mean" } } },
        { "transmittance": { "ray_marching": { "rule": "stratified", "steps": 4 } } }
      ] }"#,
    r#"{
      "title": "chromatic", "draws": 1,
      "medium": { "chromatic": { "sigma_t": [0.4, 3.0], "sigma_s": [0.3, 1.5], "length": 1.7 } },
      "subjects": [{ "chromatic": { "balance": {} } }] }"#,
];

fn seeds() -> Vec<Vec<u8>> {
    let limits = Limits::default();
    let prepared = |text: &str| CaseFile::parse(Path::new("fuzz.json"), text)?.prepare(&limits);
    let cases: Vec<Vec<Prepared>> = CASES.iter().filter_map(|text| prepared(text).ok()).collect();
    let all: Option<Vec<Value>> = cases.iter().map(|cases| files(cases)).collect();
    all.unwrap_or_default().iter().map(|files| shortened(files).to_string().into_bytes()).collect()
}

fn files(cases: &[Prepared]) -> Option<Value> {
    let never = AtomicBool::new(false);
    let options = Options { seed: 1, cancelled: &never, progress: &|_, _| (), repro: "freepath run".into() };
    let mut outcome = run::run(cases, &options).ok()?;
    outcome.timings.iter_mut().for_each(|timing| timing.seconds = 1e-3.into()); // an input is always the same
    let soaked = soak::Options {
        seed: 1,
        runs: 4,
        levels: &[0.5],
        cancelled: &never,
        progress: &|_, _| (),
        repro: "freepath soak".into(),
    };
    let timings = Timings {
        run: "run".into(),
        seconds: 1.0.into(),
        jobs: 1,
        isa: "AVX2".into(),
        out: "elsewhere".into(),
        subjects: outcome.timings,
    };
    Some(json!({
        "results": outcome.results,
        "timings": timings,
        "power": power::power(cases, &options).ok()?,
        "soak": soak::soak(cases, &soaked).ok()?,
    }))
}

fn shortened(value: &Value) -> Value {
    match value {
        Value::Array(items) => Value::Array(items.iter().take(ITEMS).map(shortened).collect()),
        Value::Object(members) => {
            Value::Object(members.iter().map(|(key, value)| (key.clone(), shortened(value))).collect())
        }
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => value.clone(),
    }
}

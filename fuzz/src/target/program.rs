//! The output of a program: to standard output, and to standard error.

use super::{PLAIN, Target};
use crate::judge::{Answer, Bounds, SMALL};
use freepath_harness::case::{CaseFile, Commands, Limits};
use freepath_harness::run::{self, Options};
use serde_json::json;
use std::path::Path;
use std::sync::atomic::AtomicBool;

/// The bytes of a file that a program writes out again and again, or once.
pub(super) const PROGRAM: Target = Target {
    name: "program",
    about: "standard output and standard error of a program",
    seeds: || {
        let doubles = |values: &[f64]| values.iter().flat_map(|x| x.to_le_bytes()).collect();
        vec![doubles(&[0.5, 0.25, 1.5]), doubles(&[0.5, f64::INFINITY]), doubles(&[0.3, 1.0, 0.5])]
    },
    reader: |folder| {
        let folder = folder.to_path_buf();
        Box::new(move |input| written(input, &folder))
    },
    bounds: Bounds { seconds: 20.0, bytes: 64 << 20, hang: 120.0, ..SMALL },
    quick: 20,
    ..PLAIN
};

/// Writes as much of the file as the request wants, and a byte more if the file is of odd length.
const SCRIPT: &str = r#"
n=$(sed 's/.*"draws":\([0-9]*\).*/\1/')
head -c 5000 bytes >&2
head -c $((8 * n + $(wc -c < bytes) % 2)) bytes
"#;

/// Bytes that the longest stage wants.
const ENOUGH: usize = 1 << 18;

fn written(input: &[u8], folder: &Path) -> Answer {
    let bytes = if input.is_empty() || input.len() % 3 == 1 {
        input.to_vec()
    } else {
        input.repeat(ENOUGH / input.len() + 2)
    };
    std::fs::write(folder.join("bytes"), bytes).map_err(|why| why.to_string())?;
    let kind = if input.len() % 16 < 8 { "free_path" } else { "transmittance" };
    let case = json!({
        "title": "program", "draws": 1,
        "medium": { "constant": { "mu": 1.2, "length": 2.0 } },
        "subjects": [{ (kind): { "command": { "argv": ["sh", "-c", SCRIPT], "timeout": 20 } } }],
    });
    let limits = Limits { commands: Commands::Started(None), ..Limits::default() };
    let file = CaseFile::parse(&folder.join("case.json"), case.to_string()).map_err(|why| why.render(false))?;
    let cases = file.prepare(&limits).map_err(|why| why.render(false))?;
    let never = AtomicBool::new(false);
    let options = Options { seed: 1, cancelled: &never, progress: &|_, _| (), repro: String::new() };
    let outcome = run::run(&cases, &options).map_err(|_| "nobody cancels")?;
    let result = &outcome.results.results[0];
    let text = freepath_report::json(&outcome.results).map_err(|why| why.to_string())?;
    assert!(text.len() < 1_000_000 && outcome.timings[0].log.len() < 300_000, "what it wrote is bounded");
    match result.notes.first() {
        Some(why) if result.mean.is_none() && result.law.is_none() => Err(why.clone()),
        _ => Ok(()),
    }
}

//! Right subjects of every kind, enough draws for every test and few seconds.

use crate::case::{CaseError, CaseFile, Limits, Prepared};
use std::path::Path;

/// Cases, at 20 blocks each: the fewest that the test of look-ups takes.
const CASES: [&str; 3] = [
    r#"{
      "title": "soak", "draws": 327680,
      "medium": { "sinusoid": { "mean": 1.0, "amplitude": 0.9, "frequency": 2.0, "phase": 0.7, "length": 2.185 } },
      "subjects": [
        { "free_path": { "delta_tracking": {} } },
        { "free_path": { "delta_tracking": { "form": "carry" } }, "majorant": { "segments": 16 } },
        { "free_path": { "ray_marching": { "rule": "jitter", "steps": 64 } }, "expect": "pass" },
        { "transmittance": { "delta_tracking": {} } },
        { "transmittance": { "ratio_tracking": {} } },
        { "transmittance": { "ratio_roulette": { "rule": "pbrt_v3" } } },
        { "transmittance": { "residual_ratio_tracking": { "control": "mean" } } },
        { "transmittance": { "ray_marching": { "rule": "stratified", "steps": 64 } } }
      ] }"#,
    r#"{
      "title": "soak of skew means", "draws": 65536,
      "medium": { "linear": { "mu0": 0.5, "mu1": 6.0, "length": 2.2 } },
      "subjects": [
        { "transmittance": { "ratio_tracking": {} }, "majorant": { "factor": 1.1 } },
        { "transmittance": { "residual_ratio_tracking": { "control": "minimum" } } }
      ] }"#,
    r#"{
      "title": "soak of chromatic weights", "draws": 65536,
      "medium": { "chromatic": { "sigma_t": [0.4, 1.1, 3.0], "sigma_s": [0.3, 1.0, 1.5], "length": 1.7 } },
      "subjects": [ { "chromatic": { "balance": {} } }, { "chromatic": { "power": {} } } ] }"#,
];

/// The built-in selection.
///
/// # Errors
/// If `limits` ask for more draws than a case may have.
pub fn quick(limits: &Limits) -> Result<Vec<Prepared>, CaseError> {
    let mut all = Vec::new();
    for (i, text) in CASES.iter().enumerate() {
        let name = format!("built_in_{i}.json");
        all.extend(CaseFile::parse(Path::new(&name), *text)?.prepare(limits)?);
    }
    Ok(all)
}

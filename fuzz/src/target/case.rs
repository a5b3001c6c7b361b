//! Case files, as far as they can be read without building a medium.

use super::{PLAIN, Target};
use freepath_harness::case::CaseFile;
use freepath_harness::diagnose::Source;
use std::path::{Path, PathBuf};

/// Case files, as text.
pub(super) const CASE: Target = Target {
    name: "case",
    about: "a case file: JSON with comments",
    seeds: || shipped().into_iter().map(|(_, text)| text.into_bytes()).collect(),
    words: WORDS,
    reader: |_| {
        Box::new(|input| {
            let text = std::str::from_utf8(input).map_err(|why| why.to_string())?;
            let name = Path::new("cases/fuzz.json");
            if let Ok(source) = Source::new("cases/fuzz.json", text) {
                shows(&source.diagnose("subjects[0].free_path", text).render(true));
            }
            CaseFile::parse(name, text).map(drop).map_err(|why| {
                shows(&why.render(true));
                why.render(false)
            })
        })
    },
    quick: 4000,
    ..PLAIN
};

/// A message is short, whatever it is about.
fn shows(message: &str) {
    assert!(message.lines().count() < 12 && message.len() < 30_000, "a message of {} bytes", message.len());
}

/// Words of a case.
pub(super) const WORDS: &[&str] = &[
    "{",
    "}",
    "[",
    "]",
    ",",
    ":",
    "\"",
    "//",
    "/*",
    "*/",
    "null",
    "true",
    "title",
    "medium",
    "majorant",
    "constant",
    "tight",
    "factor",
    "segments",
    "explicit",
    "ends",
    "mu_bar",
    "rays",
    "origin",
    "direction",
    "subjects",
    "draws",
    "budget",
    "bias_bound",
    "relative",
    "absolute",
    "tolerance",
    "resolution_bits",
    "agree",
    "free_path",
    "transmittance",
    "chromatic",
    "name",
    "expect",
    "pass",
    "fail",
    "inconclusive",
    "biased",
    "wrong_law",
    "fault",
    "masks_fault",
    "without",
    "bounded",
    "truth",
    "lookups",
    "exact",
    "closed_form",
    "delta_tracking",
    "carry",
    "form",
    "ratio_tracking",
    "ratio_roulette",
    "pbrt_v4",
    "rule",
    "residual_ratio_tracking",
    "control",
    "mean",
    "minimum",
    "value",
    "ray_marching",
    "steps",
    "stratified",
    "comb",
    "jitter",
    "regular_tracking",
    "cells",
    "cubic",
    "balance",
    "power",
    "single_channel",
    "channel",
    "channel_probabilities",
    "samples",
    "file",
    "column",
    "weight",
    "escape",
    "at_length",
    "format",
    "npy",
    "command",
    "argv",
    "timeout",
    "linear",
    "mu0",
    "mu1",
    "length",
    "mu",
    "exponential",
    "scale_height",
    "gaussian",
    "peak",
    "center",
    "width",
    "base",
    "sinusoid",
    "amplitude",
    "frequency",
    "phase",
    "box_spike",
    "start",
    "end",
    "piecewise_constant",
    "edges",
    "values",
    "piecewise_linear",
    "nodes",
    "voxel_grid",
    "filter",
    "nearest",
    "trilinear",
    "bounds",
    "scale",
    "offset",
    "raw",
    "shape",
    "channels",
    "sigma_t",
    "sigma_s",
    "scaled",
    "by",
    "reversed",
    "segment",
    "from",
    "to",
    "formula",
    "breaks",
    "short_majorant",
];

/// The shipped cases and their texts.
pub(super) fn shipped() -> Vec<(PathBuf, String)> {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../cases"));
    let files = |folder: PathBuf| std::fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok);
    let entries = files(root.to_path_buf()).chain(files(root.join("controls")));
    let cases = entries.map(|entry| entry.path()).filter(|path| path.extension().is_some_and(|end| end == "json"));
    let mut all: Vec<_> =
        cases.filter_map(|path| std::fs::read_to_string(&path).ok().map(|text| (path, text))).collect();
    all.sort();
    all
}

//! The line that tells a program what to draw.

use super::log::Log;
use super::{Program, nodes};
use crate::samples::{RowFormat, Wanted};
use freepath_estimators::Medium;
use serde_json::{Map, Value, json};
use std::io;
use std::path::PathBuf;
use std::time::Duration;

/// The version of the protocol.
const PROTOCOL: u32 = 1;

/// Where a program draws.
pub(crate) struct Setting<'a> {
    /// The name of the kind.
    pub(crate) kind: &'static str,
    /// What a row says: all of its columns come in their order.
    pub(crate) rows: RowFormat,
    /// As in the case.
    pub(crate) medium: Value,
    /// Under the majorants of the subject; none for channels.
    pub(crate) truth: Option<&'a dyn Medium>,
    pub(crate) length: f64,
    pub(crate) tolerance: f64,
    pub(crate) case_file: PathBuf,
}

impl Setting<'_> {
    fn majorants(&self) -> Vec<Value> {
        let Some(medium) = self.truth else { return Vec::new() };
        let bounds = medium.majorants();
        let of = |(end, mu_bar): (&f64, &f64)| json!({ "end": end, "mu_bar": mu_bar });
        bounds.ends().iter().zip(bounds.mu_bar()).map(of).collect()
    }
}

impl Program {
    /// `argv`, to be run in `folder` and to be killed after the silence `idle`.
    ///
    /// # Errors
    /// If the table of the medium cannot be written.
    pub(crate) fn new(argv: &[String], folder: PathBuf, idle: Duration, setting: &Setting) -> io::Result<Self> {
        let Setting { length, tolerance, .. } = *setting;
        let table = setting.truth.map(nodes::write).transpose()?.flatten();
        let mut request = json!({
            "protocol": PROTOCOL, "kind": setting.kind, "medium": setting.medium, "majorants": setting.majorants(),
            "length": length, "draws": 0, "seed": 0, "stage": 0, "case_file": setting.case_file,
        });
        let mut table_file = None;
        if let Some((file, rows)) = table {
            request["table"] = json!(file.path());
            request["rows_per_cell"] = json!(rows);
            table_file = Some(file);
        }
        let Value::Object(request) = request else { return Err(io::Error::other("no request")) };
        let (argv, format, log) = (argv.to_vec(), setting.rows.clone(), Log::default());
        Ok(Self { argv, folder, idle, format, tolerance, request, log, _table: table_file })
    }
}

/// The line for so many draws.
pub(super) fn line(request: &Map<String, Value>, draws: u64, seed: u64, stage: u32) -> Vec<u8> {
    let mut request = request.clone();
    let stated = [("draws", json!(draws)), ("seed", json!(seed)), ("stage", json!(stage))];
    stated.into_iter().for_each(|(name, value)| {
        request.insert(name.into(), value);
    });
    let mut line = Value::Object(request).to_string().into_bytes();
    line.push(b'\n');
    line
}

/// A seed below 2^53 for the start that begins with `block` (splitmix64; Steele, Lea and Flood 2014).
pub(super) fn seed(wanted: &Wanted, block: u64) -> u64 {
    let mixed = [wanted.seed, wanted.subject, block].into_iter().fold(0, |state: u64, part| mix(state ^ part));
    mixed >> 11
}

fn mix(state: u64) -> u64 {
    let z = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

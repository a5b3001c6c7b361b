//! The line that tells a program what to draw.

use super::nodes::NodeTable;
use crate::samples::{RowFormat, Wanted};
use freepath_draws::random::split_mix;
use freepath_estimators::medium::{ChannelMedium, ChromaticMedium};
use freepath_estimators::{Extinction, Medium};
use serde_json::{Map, Value, json};
use std::path::PathBuf;

/// The version of the protocol.
const PROTOCOL: u32 = 1;

/// The setting in which a program draws.
pub(crate) struct Setting<'a> {
    /// The name of the kind.
    pub(crate) kind: &'static str,
    /// The format of a row: all of its columns come in their order.
    pub(crate) rows: RowFormat,
    /// As in the case.
    pub(crate) medium: Value,
    /// Under the majorants of the subject; none for channels.
    pub(crate) truth: Option<&'a dyn Medium>,
    pub(crate) length: f64,
    pub(crate) channels: Option<&'a ChromaticMedium>,
    pub(crate) tolerance: f64,
    pub(crate) case_file: PathBuf,
}

impl Setting<'_> {
    /// The fields of every start; draws, seed and stage are stated later.
    pub(super) fn request(&self, table: Option<&NodeTable>) -> Map<String, Value> {
        let mut request = Map::new();
        let mut state = |name: &str, value: Value| request.insert(name.into(), value);
        state("protocol", json!(PROTOCOL));
        state("kind", json!(self.kind));
        state("columns", self.rows.columns.iter().map(|column| json!(column.name)).collect());
        state("medium", self.medium.clone());
        state("majorants", json!(self.majorants()));
        state("length", json!(self.length));
        ["draws", "seed", "stage"].iter().for_each(|later| drop(state(later, json!(0))));
        state("case_file", json!(self.case_file));
        if let Some(table) = table {
            state("table", json!(table.file.path()));
            state("rows_per_cell", json!(table.rows_per_cell));
            state("table_error", json!(table.error));
        }
        if let Some(channels) = self.channels {
            let sigma_t = |channel: &ChannelMedium| channel.extinction.mu(0.0);
            let sigma_s = |channel: &ChannelMedium| channel.albedo * sigma_t(channel);
            state("sigma_t", channels.media().iter().map(sigma_t).collect());
            state("sigma_s", channels.media().iter().map(sigma_s).collect());
        }
        request
    }

    fn majorants(&self) -> Vec<Value> {
        let Some(medium) = self.truth else { return Vec::new() };
        let bounds = medium.majorants();
        let of = |(end, mu_bar): (&f64, &f64)| json!({ "end": end, "mu_bar": mu_bar });
        bounds.ends().iter().zip(bounds.mu_bar()).map(of).collect()
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

/// A seed below 2^53 for the start that begins with `block`.
pub(super) fn seed(wanted: &Wanted, block: u64) -> u64 {
    let mixed =
        [wanted.seed, wanted.subject, block].into_iter().fold(0, |state: u64, part| split_mix(state ^ part));
    mixed >> 11
}

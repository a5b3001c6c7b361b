//! Programs as subjects.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A program in any language, started for each stage in the folder of the case; needs `--allow-commands`.
///
/// ```text
/// stdin:  one line of JSON: protocol, kind, medium, majorants, length, draws, seed, stage, case_file, and mu(t) as a table
/// stdout: exactly `draws` rows of doubles, little endian
///         free_path: t, infinity for an escape (or the length, within the tolerance)
///         transmittance: the estimate;  chromatic: t, event (0 scatters, 1 is the surface), one weight per channel
/// ```
///
/// Target: the free-path law, mean T, or the mean of each weight over each event.
/// Range:  [0, length] or infinity; of an estimate not known.
/// Cost:   not known: a program tells of no look-up.
/// Needs:  the same bytes for one seed, others for another; `adapters/` has the protocol for Python, C++ and C.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "command")]
pub struct Command {
    /// The program and its arguments, such as `["python3", "mine.py"]`; no shell reads them.
    #[schemars(length(min = 1))]
    pub argv: Vec<String>,
    /// Seconds of silence after which it is killed with all that it has started (default 60); ten times as many in all.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    #[schemars(range(min = 0.01, max = 86_400))]
    pub timeout: Option<f64>,
}

/// The use that a run makes of programs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Commands {
    /// They are refused.
    #[default]
    Refused,
    /// They are named, but nothing is started.
    Named,
    /// They are started, with this time limit, in seconds, instead of the case's.
    Started(Option<f64>),
}

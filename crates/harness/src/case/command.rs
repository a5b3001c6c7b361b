//! Programs as subjects.

use super::any_named::{AnyNamed, Preparing};
use super::{CaseError, SubjectSpec};
use crate::kind::Outline;
use crate::program::{IDLE, IDLE_RANGE, Program, Setting};
use crate::samples::RowFormat;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::time::Duration;

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

/// How far a run goes with programs.
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

impl Preparing<'_> {
    /// The program, along the ray of `outline`, which has the majorants of the subject.
    pub(super) fn program(
        &self,
        named: &dyn AnyNamed,
        rows: RowFormat,
        command: &Command,
        outline: &Outline,
    ) -> Result<Program, CaseError> {
        let (case, place) = (&self.file.case, self.place);
        let at = format!("{}.{}.command", self.at, named.kind());
        let idle = self.allowed(&at, self.spec, command, place.commands)?;
        let folder = std::fs::canonicalize(place.here()).unwrap_or_else(|_| place.here().to_path_buf());
        let setting = Setting {
            kind: named.kind(),
            rows,
            medium: case.scene_json(),
            truth: outline.medium,
            length: outline.length,
            channels: outline.channels,
            tolerance: self.spec.tolerance.or(case.tolerance).unwrap_or(0.0),
            case_file: self.file.path.file_name().map(|name| folder.join(name)).unwrap_or_default(),
        };
        let argv = in_folder(&command.argv, &folder);
        let cannot = |why| self.file.refuse(&at, format!("cannot tell the program its medium: {why}"));
        Program::new(&argv, folder, idle, &setting).map_err(cannot)
    }

    /// The idle limit, if the command may run at all.
    fn allowed(
        &self,
        at: &str,
        spec: &SubjectSpec,
        command: &Command,
        commands: Commands,
    ) -> Result<Duration, CaseError> {
        let refuse = |field: &str, why: &str| Err(self.file.refuse(&format!("{at}{field}"), why));
        if commands == Commands::Refused {
            let why =
                "it starts a program, which can do whatever you can (run with --allow-commands if you trust it)";
            return refuse("", why);
        }
        if !cfg!(unix) {
            return refuse("", "programs need process groups (Linux, macOS or another Unix)");
        }
        if command.argv.first().is_none_or(String::is_empty) || command.argv.iter().any(|word| word.contains('\0'))
        {
            return refuse(".argv", "argv names no program (the program and its arguments, without NUL)");
        }
        if spec.fault.is_some() {
            return refuse("", "a program draws on its own (a fault is planted in a subject of the list)");
        }
        let stated = if let Commands::Started(Some(limit)) = commands { Some(limit) } else { command.timeout };
        let (idle, (least, most)) = (stated.unwrap_or(IDLE), IDLE_RANGE);
        match idle >= least && idle <= most {
            true => Ok(Duration::from_secs_f64(idle)),
            false => refuse(".timeout", &format!("timeout must be from {least} to {most} s, not {idle}")),
        }
    }
}

/// A program with a path of its own is looked for from `folder`; one without is found as a shell finds it.
fn in_folder(argv: &[String], folder: &Path) -> Vec<String> {
    let mut argv = argv.to_vec();
    if argv[0].contains('/') {
        argv[0] = PathBuf::from(folder).join(&argv[0]).to_string_lossy().into_owned();
    }
    argv
}

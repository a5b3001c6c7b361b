//! Programs as subjects.

use super::CaseError;
use super::built_in::COMMAND;
use super::command::{Command, Commands};
use super::preparing::Preparing;
use crate::kind::Outline;
use crate::program::{IDLE, IDLE_RANGE, Program, Setting};
use crate::samples::RowFormat;
use std::path::{Path, PathBuf};
use std::time::Duration;

impl Preparing<'_> {
    /// The program, along the ray of `outline`, which has the majorants of the subject.
    pub(super) fn program(
        &self,
        kind: &'static str,
        rows: RowFormat,
        command: &Command,
        outline: &Outline,
    ) -> Result<Program, CaseError> {
        let (case, place) = (&self.file.case, self.place);
        let at = format!("{}.{kind}.{COMMAND}", self.at);
        let idle = self.allowed(&at, command, place.commands)?;
        let folder = std::fs::canonicalize(place.here()).unwrap_or_else(|_| place.here().to_path_buf());
        let setting = Setting {
            kind,
            rows,
            medium: case.scene_json(),
            truth: outline.medium,
            length: outline.length,
            channels: outline.channels,
            tolerance: self.own.tolerance.or(case.tolerance).unwrap_or(0.0),
            case_file: self.file.path.file_name().map(|name| folder.join(name)).unwrap_or_default(),
        };
        let argv = in_folder(&command.argv, &folder);
        let cannot = |why| self.file.refuse(&at, format!("cannot tell the program its medium: {why}"));
        Program::new(&argv, folder, idle, &setting).map_err(cannot)
    }

    /// The idle limit, if the command may run at all.
    fn allowed(&self, at: &str, command: &Command, commands: Commands) -> Result<Duration, CaseError> {
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
        if self.own.faults.is_some() {
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

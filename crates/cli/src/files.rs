//! Files of a report: each is written beside its place and renamed, so that it is whole or as it was.

use crate::command_error::CommandError;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process;

/// Makes the folder `out` and sees to it that files can be written there.
pub(crate) fn open(out: &Path) -> Result<(), CommandError> {
    let probe = temporary(&out.join("probe"));
    fs::create_dir_all(out)
        .and_then(|()| fs::write(&probe, ""))
        .and_then(|()| fs::remove_file(&probe))
        .map_err(|why| cannot_write(out, &why))
}

/// Writes `text` as `path`.
pub(crate) fn write(path: &Path, text: &str) -> Result<(), CommandError> {
    let temporary = temporary(path);
    let written = whole(&temporary, text).and_then(|()| fs::rename(&temporary, path));
    written.map_err(|why| {
        // What is left of it is of no use; if it cannot be removed, the first error is the one to show.
        drop(fs::remove_file(&temporary));
        cannot_write(path, &why)
    })
}

fn whole(path: &Path, text: &str) -> io::Result<()> {
    let mut file = File::create(path)?;
    file.write_all(text.as_bytes())?;
    file.sync_all()
}

fn temporary(path: &Path) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!(".{name}.tmp-{}", process::id()))
}

fn cannot_write(path: &Path, why: &io::Error) -> CommandError {
    CommandError::running(format!("cannot write {}: {why}", path.display()))
}

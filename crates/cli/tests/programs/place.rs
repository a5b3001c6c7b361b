//! Folders in which tests of programs run.

use crate::tools::python;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A test: its name, and what it does.
pub(crate) type Test = (&'static str, fn());

/// PATH with a `python3` before all others that is the interpreter of the tests.
pub(crate) fn path() -> String {
    use std::os::unix::fs::PermissionsExt;
    let folder = crate::support::folder("programs_path");
    let shim = folder.join("python3");
    let real = Command::new("sh").args(["-c", &format!("command -v '{}'", python())]).output().unwrap();
    let real = String::from_utf8(real.stdout).unwrap();
    std::fs::write(&shim, format!("#!/bin/sh\nexec '{}' \"$@\"\n", real.trim())).unwrap();
    std::fs::set_permissions(&shim, std::fs::Permissions::from_mode(0o755)).unwrap();
    format!("{}:{}", folder.display(), std::env::var("PATH").unwrap_or_default())
}

/// The workspace.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

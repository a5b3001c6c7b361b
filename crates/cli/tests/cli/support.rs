//! A folder for each test, and the binary in it.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// A case that passes.
pub(crate) const GOOD: &str = r#"{
  "title": "Gaussian bump",
  "medium": { "gaussian": { "peak": 4.0, "center": 0.9, "width": 0.25, "length": 2.0 } },
  "subjects": [
    { "free_path": { "delta_tracking": {} } },
    { "transmittance": { "ratio_tracking": {} } }
  ],
  "draws": 20000
}"#;

/// An empty folder of this name.
pub(crate) fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    if folder.exists() {
        fs::remove_dir_all(&folder).unwrap();
    }
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// A folder with `GOOD` in `cases/good.json`.
pub(crate) fn with_good(name: &str) -> PathBuf {
    let folder = folder(name);
    put(&folder, "cases/good.json", GOOD);
    folder
}

/// Writes `text` as `file` in `folder`.
pub(crate) fn put(folder: &Path, file: &str, text: &str) {
    let path = folder.join(file);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}

/// The binary, to be run in `folder`.
pub(crate) fn freepath(folder: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_freepath"));
    command.current_dir(folder).args(args).stdin(Stdio::null());
    for name in ["NO_COLOR", "CLICOLOR_FORCE", "FREEPATH_ISA"] {
        command.env_remove(name);
    }
    command
}

/// Exit code, standard output and standard error.
pub(crate) fn run(folder: &Path, args: &[&str]) -> (i32, String, String) {
    decoded(&freepath(folder, args).output().unwrap())
}

/// Exit code and text of a process that has ended.
pub(crate) fn decoded(output: &Output) -> (i32, String, String) {
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    (output.status.code().unwrap(), text(&output.stdout), text(&output.stderr))
}

/// Every file below `folder`, with its bytes.
pub(crate) fn contents(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(contents(&path));
        } else {
            let bytes = fs::read(&path).unwrap();
            found.push((path, bytes));
        }
    }
    found.sort();
    found
}

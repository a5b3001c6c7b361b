//! What tests of other languages need.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// A test: its name, what it needs, and what it does.
pub(crate) type Test = (&'static str, &'static [Tool], fn());

/// A program of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Tool {
    Python,
    C,
    Cpp,
}

impl Tool {
    pub(crate) fn is_there(self) -> bool {
        let (program, args): (_, &[&str]) = match self {
            Self::Python => (python(), &["-c", "import numpy"]),
            Self::C => ("cc".into(), &["--version"]),
            Self::Cpp => ("c++".into(), &["--version"]),
        };
        let status = Command::new(program).args(args).stdout(Stdio::null()).stderr(Stdio::null()).status();
        status.is_ok_and(|status| status.success())
    }

    pub(crate) fn how_to_get(self) -> &'static str {
        match self {
            Self::Python => {
                "there is no python3 with NumPy (install python3-numpy, or name an interpreter by FREEPATH_PYTHON)"
            }
            Self::C => "there is no `cc` (install a C compiler, such as gcc)",
            Self::Cpp => "there is no `c++` (install a C++17 compiler, such as g++)",
        }
    }
}

/// The interpreter.
fn python() -> String {
    std::env::var("FREEPATH_PYTHON").unwrap_or_else(|_| "python3".into())
}

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

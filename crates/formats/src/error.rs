//! Reasons why bytes are not used.

use std::path::{Path, PathBuf};
use std::{fmt, io};

/// A file that cannot be used: which, why, and what is allowed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReadError {
    file: PathBuf,
    refusal: Refusal,
}

impl ReadError {
    /// The refusal of `file`.
    #[must_use]
    pub fn new(file: &Path, refusal: Refusal) -> Self {
        Self { file: file.to_path_buf(), refusal }
    }

    /// The file.
    #[must_use]
    pub fn file(&self) -> &Path {
        &self.file
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "cannot read {}: {}", self.file.display(), self.refusal)
    }
}

impl std::error::Error for ReadError {}

/// The reason why some bytes cannot be used, whatever file they are from, and what is allowed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    pub(crate) cause: String,
    pub(crate) allowed: String,
}

impl Refusal {
    /// A clause that says why, and what could stand there instead.
    pub fn new(cause: impl Into<String>, allowed: impl Into<String>) -> Self {
        let (cause, allowed) = (cause.into(), allowed.into());
        Self { cause, allowed }
    }

    /// The same, and in what place.
    pub(crate) fn at(self, place: &str) -> Self {
        Self { cause: format!("{} in {place}", self.cause), ..self }
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({})", self.cause, self.allowed)
    }
}

impl From<io::Error> for Refusal {
    fn from(error: io::Error) -> Self {
        Self::new(error.to_string(), "a file that can be read")
    }
}

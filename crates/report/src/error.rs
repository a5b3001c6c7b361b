//! Errors while a report is made.

use std::fmt;
use std::path::{Path, PathBuf};

/// The reason why a report could not be made.
#[derive(Debug)]
#[non_exhaustive]
pub enum ReportError {
    /// A file or folder could not be written.
    Write {
        /// The file or folder.
        path: PathBuf,
        /// The cause.
        cause: std::io::Error,
    },
    /// A plot could not be drawn.
    Draw(String),
    /// The page could not be filled in.
    Page(String),
}

impl ReportError {
    pub(crate) fn write(path: &Path, cause: std::io::Error) -> Self {
        Self::Write { path: path.to_path_buf(), cause }
    }
}

impl fmt::Display for ReportError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Write { path, cause } => write!(f, "cannot write {}: {cause}", path.display()),
            Self::Draw(cause) => write!(f, "cannot draw a plot: {cause}"),
            Self::Page(cause) => write!(f, "cannot fill in the page: {cause}"),
        }
    }
}

impl std::error::Error for ReportError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Write { cause, .. } => Some(cause),
            Self::Draw(_) | Self::Page(_) => None,
        }
    }
}

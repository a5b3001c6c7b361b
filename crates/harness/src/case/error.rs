use crate::diagnose::Diagnosis;
use std::fmt;
use std::path::Path;

/// The reason why a case cannot be used.
#[derive(Clone, Debug, PartialEq)]
pub enum CaseError {
    /// The file cannot be read: one sentence.
    File(String),
    /// A place in it.
    Place(Diagnosis),
}

impl CaseError {
    /// `path` cannot be read because of `why`.
    pub(crate) fn unreadable(path: &Path, why: impl fmt::Display) -> Self {
        Self::File(format!("cannot read {}: {why}", path.display()))
    }

    /// The message, with the place underlined, in colour if the terminal takes it.
    #[must_use]
    pub fn render(&self, color: bool) -> String {
        match self {
            Self::File(sentence) => format!("error: {sentence}"),
            Self::Place(diagnosis) => diagnosis.render(color),
        }
    }
}

impl From<Diagnosis> for CaseError {
    fn from(diagnosis: Diagnosis) -> Self {
        Self::Place(diagnosis)
    }
}

impl fmt::Display for CaseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.render(false))
    }
}

impl std::error::Error for CaseError {}

//! Why the program ends without a result, and its exit code.

use std::fmt::Display;

/// Why a command ended early.
#[derive(Debug)]
pub(crate) enum Trouble {
    /// What it was given cannot be used: messages, ready to be shown.
    Unusable(Vec<String>),
    /// Something went wrong on the way.
    Running(String),
    /// It was asked to stop.
    Interrupted,
}

impl Trouble {
    /// One sentence about input that cannot be used.
    pub(crate) fn unusable(sentence: impl Display) -> Self {
        Self::Unusable(vec![format!("error: {sentence}")])
    }

    /// The exit code.
    pub(crate) fn code(&self) -> u8 {
        match self {
            Self::Unusable(_) => 2,
            Self::Running(_) => 3,
            Self::Interrupted => 130,
        }
    }

    /// What to show.
    pub(crate) fn message(&self) -> String {
        match self {
            Self::Unusable(messages) => messages.join("\n\n"),
            Self::Running(sentence) => format!("error: {sentence}"),
            Self::Interrupted => "interrupted: nothing was written, an earlier report is as it was".into(),
        }
    }
}

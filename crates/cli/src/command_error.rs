//! The error of a command that ends without a result, and its exit code.

use std::fmt::Display;

/// The reason why a command ended early.
#[derive(Debug)]
pub(crate) enum CommandError {
    /// Unusable input: messages, ready to be shown.
    Unusable(Vec<String>),
    /// Something went wrong on the way.
    Running(String),
    /// It was asked to stop.
    Interrupted,
}

impl CommandError {
    /// One sentence about input that cannot be used.
    pub(crate) fn unusable(sentence: impl Display) -> Self {
        Self::Unusable(vec![format!("error: {sentence}")])
    }

    /// Something that went wrong on the way.
    pub(crate) fn running(sentence: impl Display) -> Self {
        Self::Running(sentence.to_string())
    }

    /// The exit code.
    pub(crate) fn code(&self) -> u8 {
        match self {
            Self::Unusable(_) => 2,
            Self::Running(_) => 3,
            Self::Interrupted => 130,
        }
    }

    /// The text to show.
    pub(crate) fn message(&self) -> String {
        match self {
            Self::Unusable(messages) => messages.join("\n\n"),
            Self::Running(sentence) => format!("error: {sentence}"),
            Self::Interrupted => "interrupted: nothing was written, an earlier report is as it was".into(),
        }
    }
}

//! The arguments of a case or a command line on a file of samples.

use super::{Body, Outline};
use crate::samples::{Escape, RowFormat};
use freepath_formats::Format;

/// The arguments of a command line on a file of samples.
#[derive(Clone, Debug, Default)]
pub struct SampleArguments {
    /// Its name, or `-` for standard input.
    pub file: String,
    /// The column.
    pub column: Option<String>,
    /// The column of weights.
    pub weight: Option<String>,
    /// The definition of an escape.
    pub escape: Escape,
    /// Its format.
    pub format: Option<Format>,
}

impl SampleArguments {
    /// The same, of values that are no free paths.
    pub(super) fn without_paths(self) -> Result<Self, &'static str> {
        if self.weight.is_some() || self.escape != Escape::default() {
            return Err("cannot use --weight or --escape: they belong to free paths (--as free_path)");
        }
        Ok(self)
    }
}

/// A file of samples of one kind.
pub trait SamplesSpec: Body {
    /// Its name.
    fn file(&self) -> &str;

    /// The format of a row in this scene.
    fn rows(&self, outline: &Outline) -> RowFormat;

    /// The format of the file.
    fn format(&self) -> Option<Format>;

    /// True if a row has a weight. Provided: it has none.
    fn weighted(&self) -> bool {
        false
    }

    /// As a command line has it.
    ///
    /// # Errors
    /// If an argument belongs to another kind, in words.
    fn from_arguments(arguments: SampleArguments) -> Result<Self, &'static str>;
}

//! Subjects whose draws are made elsewhere.

use crate::program::Program;
use crate::samples::{SampleFile, SampleSource};

/// The origin of the draws of a subject that does not make them here.
pub enum Origin {
    /// An open file of samples, and what it says.
    File(SampleFile),
    /// A program.
    Program(Program),
}

impl Origin {
    /// The file, if it is one.
    #[must_use]
    pub(crate) fn file(&self) -> Option<&SampleFile> {
        match self {
            Self::File(file) => Some(file),
            Self::Program(_) => None,
        }
    }

    /// A program's output on standard error so far.
    #[must_use]
    pub(crate) fn log(&self) -> String {
        match self {
            Self::File(_) => String::new(),
            Self::Program(program) => program.log(),
        }
    }

    /// Bits of the numbers.
    #[must_use]
    pub(crate) fn resolution_bits(&self) -> u32 {
        self.file().map_or(f64::MANTISSA_DIGITS, SampleFile::resolution_bits)
    }

    /// The most by which any claim may be off.
    #[must_use]
    pub(crate) fn tolerance(&self) -> f64 {
        self.file().map_or(0.0, SampleFile::tolerance)
    }

    /// The source that is read.
    #[must_use]
    pub(crate) fn source(&self) -> &dyn SampleSource {
        match self {
            Self::File(file) => file,
            Self::Program(program) => program,
        }
    }
}

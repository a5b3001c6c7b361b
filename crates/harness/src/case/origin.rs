//! Subjects whose draws are made elsewhere.

use super::samples::Samples;
use super::surroundings::Place;
use super::{CaseError, CaseFile, Subject, World};
use crate::program::Program;
use crate::samples::SampleKind;
use crate::source::samples::SampleFile;
use crate::subject::Work;
use freepath_estimators::Medium;
use std::sync::Arc;

/// Where the draws of a subject come from, if it does not make them here.
pub enum Origin {
    /// An open file of samples, and what it says.
    File(SampleKind, SampleFile),
    /// A program.
    Program(Program),
}

impl Origin {
    /// The file, if it is one.
    #[must_use]
    pub fn file(&self) -> Option<&SampleFile> {
        match self {
            Self::File(_, file) => Some(file),
            Self::Program(_) => None,
        }
    }

    /// What a program has said on standard error.
    #[must_use]
    pub fn log(&self) -> String {
        match self {
            Self::File(..) => String::new(),
            Self::Program(program) => program.log(),
        }
    }

    /// Bits of the numbers.
    #[must_use]
    pub fn resolution_bits(&self) -> u32 {
        self.file().map_or(f64::MANTISSA_DIGITS, SampleFile::resolution_bits)
    }

    /// How far every claim may be off.
    #[must_use]
    pub fn tolerance(&self) -> f64 {
        self.file().map_or(0.0, SampleFile::tolerance)
    }

    /// What is run.
    #[must_use]
    pub fn work(&self) -> Work<'_> {
        match self {
            Self::File(kind, file) => Work::Samples(*kind, file),
            Self::Program(program) => Work::Samples(program.kind(), program),
        }
    }
}

impl CaseFile {
    /// The file or the program that `spec` is, if it is one.
    pub(super) fn source(
        &self,
        at: &str,
        spec: &Subject,
        (world, truth): (&World, Option<&Arc<dyn Medium>>),
        place: &Place,
    ) -> Result<Option<Origin>, CaseError> {
        if let Some(program) = self.program(at, spec, (world, truth), place)? {
            return Ok(Some(Origin::Program(program)));
        }
        let file = self.sample_file(at, spec, world, place)?;
        Ok(file.zip(spec.samples().map(Samples::kind)).map(|(file, kind)| Origin::File(kind, file)))
    }
}

//! Files of samples as subjects.

use super::CaseError;
use super::built_in::SAMPLES;
use super::preparing::Preparing;
use crate::kind::{Outline, SamplesSpec};
use crate::samples::{Request, RowFormat, SampleFile};
use freepath_formats::Format;
use std::path::PathBuf;

/// A [`SamplesSpec`] without its type.
pub(crate) trait AnySamples {
    fn file(&self) -> &str;
    fn rows(&self, outline: &Outline) -> RowFormat;
    fn format(&self) -> Option<Format>;
    fn weighted(&self) -> bool;
}

impl<S: SamplesSpec> AnySamples for S {
    fn file(&self) -> &str {
        self.file()
    }
    fn rows(&self, outline: &Outline) -> RowFormat {
        self.rows(outline)
    }
    fn format(&self) -> Option<Format> {
        self.format()
    }
    fn weighted(&self) -> bool {
        self.weighted()
    }
}

impl Preparing<'_> {
    /// The file, opened.
    pub(super) fn sample_file(
        &self,
        kind: &str,
        samples: &dyn AnySamples,
        outline: &Outline,
    ) -> Result<SampleFile, CaseError> {
        let (case, own, at) = (&self.file.case, &self.own, &self.at);
        let rays = case.rays.len();
        if rays > 1 && self.file.checked.flatten().is_none() {
            let why = format!(
                "samples belong to one ray, and the case has {rays} (state one, or make it a case of its own)"
            );
            return Err(self.file.refuse(at, why));
        }
        if own.faults.is_some() {
            let why = "samples are drawn already (a fault is planted in a subject that draws)";
            return Err(self.file.refuse(&format!("{at}.fault"), why));
        }
        let refuse = |why: &dyn std::fmt::Display| self.file.refuse(&format!("{at}.{kind}.{SAMPLES}.file"), why);
        let path = self.place_of(samples.file()).map_err(|why| refuse(&why))?;
        let tolerance = own.tolerance.or(case.tolerance);
        let (rows, format) = (samples.rows(outline), samples.format());
        let request = Request { rows, format, draws: own.draws, tolerance, group: own.replicates };
        SampleFile::open(&path, &request).map_err(|why| refuse(&why))
    }

    fn place_of(&self, file: &str) -> Result<PathBuf, String> {
        match (self.file.checked, file) {
            (Some(_), file) => Ok(file.into()),
            (None, "-") => Err("a case cannot read samples from standard input (`freepath check -` can)".into()),
            (None, file) => self.place.resolve(file).map_err(|why| why.to_string()),
        }
    }
}

//! Files of samples as subjects.

use super::surroundings::Place;
use super::{CaseError, CaseFile, Subject, World};
use crate::samples::SampleKind;
use crate::source::samples::{Escape, Format, Request, SampleFile};
use freepath_estimators::Extinction;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

fn by_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

/// A file of free paths that any program has drawn: the first third of its rows, in drawing order, is stage 1, the rest
/// stage 2, and all are judged.
///
/// ```text
/// t as drawn, infinity for an escape, or t >= length if it is declared so
/// ```
///
/// Target: the free-path law; with weights, the weighted mean of each event.
/// Range:  [0, length], or infinity.
/// Cost:   not known: a file tells of no look-up.
/// Needs:  `.npy`, `.csv`, `.txt` or `.f64`; float32 is judged at 24 bits and a tolerance of 6e-8.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FreePathSamples {
    /// Its name, from the folder of the case.
    pub file: String,
    /// The column of t, by name or by number from 0 (default: the only one).
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub column: Option<String>,
    /// The column of statistical weights, by name or by number from 0.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub weight: Option<String>,
    /// What an escape is.
    #[serde(skip_serializing_if = "by_default", default)]
    #[schemars(extend("default" = "infinity"))]
    pub escape: Escape,
    /// How it is written (default: as the ending of its name tells).
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub format: Option<Format>,
}

/// A file of transmittance estimates that any program has drawn: the first third of its rows, in drawing order, is stage 1,
/// the rest stage 2, and all are judged.
///
/// Target: mean T.
/// Range:  not known.
/// Cost:   not known: a file tells of no look-up.
/// Needs:  `.npy`, `.csv`, `.txt` or `.f64`; float32 is judged with a tolerance of 6e-8.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TransmittanceSamples {
    /// Its name, from the folder of the case.
    pub file: String,
    /// The column of estimates, by name or by number from 0 (default: the only one).
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub column: Option<String>,
    /// How it is written (default: as the ending of its name tells).
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub format: Option<Format>,
}

/// A file of chromatic draws that any program has made, with the columns t, event, w0, w1, .. (one weight per channel): the
/// first third of its rows, in drawing order, is stage 1, the rest stage 2, and all are judged.
///
/// ```text
/// event 0 or scatter: w_k estimates the albedo times the density of scattering at t
/// event 1 or surface: w_k estimates the transmittance, and t is not looked at
/// ```
///
/// Target: the mean of each weight over each event, and over bins of t, whatever the sampler's own density.
/// Range:  t in [0, length].
/// Cost:   not known: a file tells of no look-up.
/// Needs:  `.csv` or `.txt` with these names in its first line; `.npy` or `.f64` in this order, C order, event 0 or 1.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ChromaticSamples {
    /// Its name, from the folder of the case.
    pub file: String,
    /// How it is written (default: as the ending of its name tells).
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub format: Option<Format>,
}

/// A file of samples of any kind.
#[derive(Clone, Copy, Debug)]
pub(super) enum Samples<'a> {
    FreePath(&'a FreePathSamples),
    Transmittance(&'a TransmittanceSamples),
    Chromatic(&'a ChromaticSamples),
}

impl<'a> Samples<'a> {
    pub(super) fn file(self) -> &'a str {
        match self {
            Self::FreePath(samples) => &samples.file,
            Self::Transmittance(samples) => &samples.file,
            Self::Chromatic(samples) => &samples.file,
        }
    }

    pub(super) fn kind(self) -> SampleKind {
        match self {
            Self::FreePath(samples) if samples.weight.is_some() => SampleKind::WeightedFreePath,
            Self::FreePath(_) => SampleKind::FreePath,
            Self::Transmittance(_) => SampleKind::Transmittance,
            Self::Chromatic(_) => SampleKind::Chromatic,
        }
    }

    /// What is asked of the file, on a ray of this length, with weights for so many channels.
    pub(super) fn request(self, length: f64, channels: usize) -> Request<'a> {
        let (column, weight, escape, format) = match self {
            Self::FreePath(s) => (s.column.as_deref(), s.weight.as_deref(), s.escape, s.format),
            Self::Transmittance(s) => (s.column.as_deref(), None, Escape::default(), s.format),
            Self::Chromatic(s) => (None, None, Escape::default(), s.format),
        };
        let kind = self.kind();
        Request { kind, format, column, weight, escape, channels, length, draws: None, tolerance: None }
    }
}

impl CaseFile {
    /// The same case with `subject` alone, which the file does not hold: its file of samples is named from where the
    /// program runs, and may be anywhere, or `-` for standard input. `ray` is one of the case's rays.
    ///
    /// # Errors
    /// If the case has rays and `ray` is none of them.
    pub fn checking(mut self, subject: Subject, ray: Option<usize>) -> Result<Self, CaseError> {
        if let Some(ray) = ray.filter(|&ray| ray >= self.case.rays.len()) {
            let (path, rays) = (self.path.display(), self.case.rays.len());
            let why = format!("cannot find ray {ray} of {path}: it has {rays} (they are numbered from 0)");
            return Err(CaseError::File(why));
        }
        (self.case.subjects, self.checked) = (vec![subject], Some(ray));
        Ok(self)
    }

    /// The open file, if `spec` is one of samples.
    pub(super) fn sample_file(
        &self,
        at: &str,
        spec: &Subject,
        world: &World,
        place: &Place,
    ) -> Result<Option<SampleFile>, CaseError> {
        let Some(samples) = spec.samples() else { return Ok(None) };
        let rays = self.case.rays.len();
        if rays > 1 && self.checked.flatten().is_none() {
            let why = format!(
                "samples belong to one ray, and the case has {rays} (state one, or make it a case of its own)"
            );
            return Err(self.refuse(at, why));
        }
        if spec.fault.is_some() {
            let why = "samples are drawn already (a fault is planted in a subject that draws)";
            return Err(self.refuse(&format!("{at}.fault"), why));
        }
        let refuse = |why: &dyn std::fmt::Display| {
            let (kind, name) = spec.kind();
            self.refuse(&format!("{at}.{kind}.{name}.file"), why)
        };
        let path = self.place_of(samples.file(), place).map_err(|why| refuse(&why))?;
        let (length, channels) = match world {
            World::Grey(medium) => (medium.length(), 0),
            World::Chromatic(medium) => (medium.length(), medium.media().len()),
        };
        let tolerance = spec.tolerance.or(self.case.tolerance);
        let request = Request { draws: spec.draws, tolerance, ..samples.request(length, channels) };
        SampleFile::open(&path, &request).map(Some).map_err(|why| refuse(&why))
    }

    fn place_of(&self, file: &str, place: &Place) -> Result<PathBuf, String> {
        match (self.checked, file) {
            (Some(_), file) => Ok(file.into()),
            (None, "-") => Err("a case cannot read samples from standard input (`freepath check -` can)".into()),
            (None, file) => place.resolve(file).map_err(|why| why.to_string()),
        }
    }
}

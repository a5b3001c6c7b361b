//! Files of samples as subjects.

use super::any_named::{AnyNamed, Preparing};
use super::{CaseError, CaseFile, SubjectSpec};
use crate::kind::{Body, Outline};
use crate::samples::{Escape, EscapeRule, Place, Request, RowFormat, SampleFile};
use freepath_formats::Format;
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

/// What a command line says of a file of samples.
#[derive(Clone, Debug, Default)]
pub struct SampleArguments {
    /// Its name, or `-` for standard input.
    pub file: String,
    /// The column.
    pub column: Option<String>,
    /// The column of weights.
    pub weight: Option<String>,
    /// What an escape is.
    pub escape: Escape,
    /// How it is written.
    pub format: Option<Format>,
}

/// A file of samples of one kind.
pub trait SamplesSpec: Body {
    /// Its name.
    fn file(&self) -> &str;

    /// What a row says in this scene.
    fn rows(&self, outline: &Outline) -> RowFormat;

    /// How it is written.
    fn format(&self) -> Option<Format>;

    /// As a command line has it.
    ///
    /// # Errors
    /// If an argument belongs to another kind, in words.
    fn from_arguments(arguments: SampleArguments) -> Result<Self, &'static str>;
}

/// A [`SamplesSpec`] without its type.
pub(crate) trait AnySamples {
    fn file(&self) -> &str;
    fn rows(&self, outline: &Outline) -> RowFormat;
    fn format(&self) -> Option<Format>;
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
}

/// Why weights and escapes are refused.
const NO_PATHS: &str = "cannot use --weight or --escape: they belong to free paths (--as free_path)";

impl SampleArguments {
    fn is_weighted(&self) -> bool {
        self.weight.is_some() || self.escape != Escape::default()
    }
}

impl SamplesSpec for FreePathSamples {
    fn file(&self) -> &str {
        &self.file
    }
    fn rows(&self, outline: &Outline) -> RowFormat {
        let rule = EscapeRule { length: outline.length, escapes: self.escape.into() };
        let column = Place::stated(self.column.as_deref());
        match &self.weight {
            None => RowFormat::free_path(column, rule),
            Some(weight) => RowFormat::weighted_free_path(column, Place::Stated(weight.clone()), rule),
        }
    }
    fn format(&self) -> Option<Format> {
        self.format
    }
    fn from_arguments(arguments: SampleArguments) -> Result<Self, &'static str> {
        let SampleArguments { file, column, weight, escape, format } = arguments;
        Ok(Self { file, column, weight, escape, format })
    }
}

impl SamplesSpec for TransmittanceSamples {
    fn file(&self) -> &str {
        &self.file
    }
    fn rows(&self, _: &Outline) -> RowFormat {
        RowFormat::estimate(Place::stated(self.column.as_deref()))
    }
    fn format(&self) -> Option<Format> {
        self.format
    }
    fn from_arguments(arguments: SampleArguments) -> Result<Self, &'static str> {
        if arguments.is_weighted() {
            return Err(NO_PATHS);
        }
        let SampleArguments { file, column, format, .. } = arguments;
        Ok(Self { file, column, format })
    }
}

impl SamplesSpec for ChromaticSamples {
    fn file(&self) -> &str {
        &self.file
    }
    fn rows(&self, outline: &Outline) -> RowFormat {
        RowFormat::chromatic(outline.length, outline.weights)
    }
    fn format(&self) -> Option<Format> {
        self.format
    }
    fn from_arguments(arguments: SampleArguments) -> Result<Self, &'static str> {
        if arguments.is_weighted() {
            return Err(NO_PATHS);
        }
        if arguments.column.is_some() {
            return Err("cannot use --column: chromatic samples have the columns t, event, w0, w1, ..");
        }
        let SampleArguments { file, format, .. } = arguments;
        Ok(Self { file, format })
    }
}

impl CaseFile {
    /// The same case with `subject` alone, which the file does not hold: its file of samples is named from where the
    /// program runs, and may be anywhere, or `-` for standard input. `ray` is one of the case's rays.
    ///
    /// # Errors
    /// If the case has rays and `ray` is none of them.
    pub fn checking(mut self, subject: SubjectSpec, ray: Option<usize>) -> Result<Self, CaseError> {
        if let Some(ray) = ray.filter(|&ray| ray >= self.case.rays.len()) {
            let (path, rays) = (self.path.display(), self.case.rays.len());
            let why = format!("cannot find ray {ray} of {path}: it has {rays} (they are numbered from 0)");
            return Err(CaseError::File(why));
        }
        (self.case.subjects, self.checked) = (vec![subject], Some(ray));
        Ok(self)
    }
}

impl Preparing<'_> {
    /// The file, opened.
    pub(super) fn sample_file(
        &self,
        named: &dyn AnyNamed,
        samples: &dyn AnySamples,
        outline: &Outline,
    ) -> Result<SampleFile, CaseError> {
        let (case, spec, at) = (&self.file.case, self.spec, &self.at);
        let rays = case.rays.len();
        if rays > 1 && self.file.checked.flatten().is_none() {
            let why = format!(
                "samples belong to one ray, and the case has {rays} (state one, or make it a case of its own)"
            );
            return Err(self.file.refuse(at, why));
        }
        if spec.fault.is_some() {
            let why = "samples are drawn already (a fault is planted in a subject that draws)";
            return Err(self.file.refuse(&format!("{at}.fault"), why));
        }
        let refuse = |why: &dyn std::fmt::Display| {
            self.file.refuse(&format!("{at}.{}.{}.file", named.kind(), named.name()), why)
        };
        let path = self.place_of(samples.file()).map_err(|why| refuse(&why))?;
        let tolerance = spec.tolerance.or(case.tolerance);
        let (rows, format) = (samples.rows(outline), samples.format());
        let request = Request { rows, format, draws: spec.draws, tolerance };
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

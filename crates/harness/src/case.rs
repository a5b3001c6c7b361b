//! Case files: what to verify, as data.

use crate::agree::Agreement;
use crate::diagnose::{Diagnosis, MAX_BYTES, Source};
use crate::scene::AnyScene;
use freepath_estimators::MajorantChoice;
use freepath_estimators::medium::AnyMedium;
use freepath_statistics::claim::BiasBound;
use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

mod any_named;
mod built_in;
mod case_folder;
mod check;
mod command;
mod error;
pub mod example;
mod external;
mod faults;
mod kind_entry;
mod listed;
mod name;
mod named;
mod prepare;
mod preparing;
mod program;
mod registry;
mod sample_file;
mod schema;
mod subject;

pub use command::{Command, Commands};
pub use error::CaseError;
pub use external::External;
pub use faults::Faults;
pub use freepath_estimators::medium::Ray;
pub use kind_entry::KindEntry;
pub use named::Named;
pub use prepare::{Limits, Prepared, PreparedSubject};
pub use registry::{ListError, Lists};
pub use schema::{resolve, variants};
pub use subject::{KINDS, SubjectSpec};

/// Most draws of one stage.
pub const MOST_DRAWS: u64 = 1_000_000_000_000;

/// One scene, many subjects.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "case", extend("oneOf" = [{"required": ["medium"]}, {"required": ["scene"]}]))]
pub struct Case {
    /// The schema of this file, for editors.
    #[serde(rename = "$schema", skip_serializing_if = "Option::is_none", default)]
    pub schema: Option<String>,
    /// The topic of the case, in a line.
    pub title: String,
    /// The medium along the ray: the scene of free paths, transmittances and channels.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub medium: Option<AnyMedium>,
    /// Any other scene.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub scene: Option<AnyScene>,
    /// The majorant under which subjects see it.
    #[serde(default)]
    pub majorant: MajorantChoice,
    /// Rays through a voxel grid, instead of the medium's own: one row of results for each.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub rays: Vec<Ray>,
    /// The subjects under test.
    #[schemars(length(min = 1))]
    pub subjects: Vec<SubjectSpec>,
    /// Draws of stage 1 (default 1,000,000), rounded up to whole blocks of 16,384.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    #[schemars(range(min = 1, max = MOST_DRAWS))]
    pub draws: Option<u64>,
    /// Draws at which growth towards `bias_bound` ends (default 64 times `draws`).
    #[serde(skip_serializing_if = "Option::is_none", default)]
    #[schemars(range(min = 1, max = MOST_DRAWS))]
    pub budget: Option<u64>,
    /// A pass is inconclusive until the bias is bounded so far.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub bias_bound: Option<BiasBound>,
    /// Subjects may be off by so much in every claim (default 0; of samples in single precision, 6e-8).
    #[serde(skip_serializing_if = "Option::is_none", default)]
    #[schemars(range(min = 0, max = 1))]
    pub tolerance: Option<f64>,
    /// Bits of the subjects' uniforms (default 52; of samples, 24 in single and 53 in double precision), for the test of ties.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    #[schemars(range(min = 8, max = 53))]
    pub resolution_bits: Option<u32>,
    /// Other settings in which every subject must agree with itself; each draws as much again.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub agree: Vec<Agreement>,
}

impl Case {
    /// The name of its scene.
    #[must_use]
    pub(crate) fn scene_name(&self) -> &'static str {
        let medium = self.medium.as_ref().map(AnyMedium::name);
        medium.or(self.scene.as_ref().map(AnyScene::name)).unwrap_or_default()
    }

    /// Its scene, as the case has it.
    #[must_use]
    pub(crate) fn scene_json(&self) -> serde_json::Value {
        let medium = self.medium.as_ref().map(serde_json::to_value);
        let json = medium.or_else(|| self.scene.as_ref().map(serde_json::to_value));
        json.transpose().ok().flatten().unwrap_or_default()
    }
}

/// The JSON schema of a case (draft 2020-12).
#[must_use]
pub fn schema() -> serde_json::Value {
    let generator = SchemaSettings::draft2020_12().into_generator();
    generator.into_root_schema_for::<Case>().to_value()
}

/// A case with the file that it came from.
#[derive(Debug)]
pub struct CaseFile {
    /// As it was named.
    pub path: PathBuf,
    /// The text with its places, for messages.
    pub source: Source,
    /// Its content.
    pub case: Case,
    /// The ray, if any, of a subject that came from elsewhere; none if it did not.
    checked: Option<Option<usize>>,
}

impl CaseFile {
    /// Reads and parses `path`.
    ///
    /// # Errors
    /// If the file cannot be read or does not say a case.
    pub fn load(path: &Path) -> Result<Self, CaseError> {
        let text = case_folder::read_text(path, MAX_BYTES as u64)?;
        Self::parse(path, text)
    }

    /// A case that is not in a file: `path` is the name to show, and relative names are relative to its folder.
    ///
    /// # Errors
    /// If the text does not say a case.
    pub fn parse(path: &Path, text: impl Into<String>) -> Result<Self, CaseError> {
        let source = Source::new(path.display().to_string(), text)?;
        let case = source.read().map_err(|found| located(&source, found))?;
        Ok(Self { path: path.to_path_buf(), source, case, checked: None })
    }

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

/// `found`, but shown at its own place if it is about the parameters of a sampler of another crate.
fn located(source: &Source, found: Diagnosis) -> Diagnosis {
    let kind = found.path().rsplit_once('.').and_then(|(_, last)| KINDS.iter().find(|kind| kind.name == last));
    kind.and_then(|kind| (kind.closer)(source, found.path())).unwrap_or(found)
}

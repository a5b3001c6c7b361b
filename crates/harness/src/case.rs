//! Case files: what to verify, as data.

use crate::agree::Agreement;
use crate::diagnose::{MAX_BYTES, Source};
use crate::fault::Expectation;
use freepath_estimators::MajorantChoice;
use freepath_estimators::medium::AnyMedium;
use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

mod agree;
mod brought;
mod check;
mod command;
mod error;
pub mod example;
mod faults;
mod fit;
mod listed;
mod name;
mod origin;
mod prepare;
mod samples;
mod schema;
mod subject;
mod surroundings;

pub use crate::claim::{BiasBound, Claim};
pub use brought::{Brought, ListError, Lists};
pub use command::{Command, Commands};
pub use error::CaseError;
pub use faults::Faults;
pub use origin::Origin;
pub use prepare::{Limits, Prepared, PreparedSubject, World};
pub use samples::{ChromaticSamples, FreePathSamples, TransmittanceSamples};
pub use schema::{resolve, variants};
pub use subject::{ChromaticSubject, ClosedForm, Exact, FreePathSubject, TransmittanceSubject};

/// Most draws of one stage.
pub const MOST_DRAWS: u64 = 1_000_000_000_000;

/// One medium, many subjects.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "case")]
pub struct Case {
    /// The schema of this file, for editors.
    #[serde(rename = "$schema", skip_serializing_if = "Option::is_none", default)]
    pub schema: Option<String>,
    /// What the case is about, in a line.
    pub title: String,
    /// The medium along the ray.
    pub medium: AnyMedium,
    /// The majorant under which subjects see it.
    #[serde(default)]
    pub majorant: MajorantChoice,
    /// Rays through a voxel grid, instead of the medium's own: one row of results for each.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub rays: Vec<Ray>,
    /// What is tested.
    #[schemars(length(min = 1))]
    pub subjects: Vec<Subject>,
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

/// A ray through a voxel grid.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Ray {
    /// Where it starts, in world coordinates.
    pub origin: [f64; 3],
    /// Where it goes; of any length.
    pub direction: [f64; 3],
}

/// One subject: exactly one of `free_path`, `transmittance` and `chromatic`, and what it overrides of the case.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("oneOf" = [{"required": ["free_path"]}, {"required": ["transmittance"]}, {"required": ["chromatic"]}]))]
pub struct Subject {
    /// A free-path sampler.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub free_path: Option<FreePathSubject>,
    /// A transmittance estimator.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub transmittance: Option<TransmittanceSubject>,
    /// A chromatic sampler.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub chromatic: Option<ChromaticSubject>,
    /// Its name in the results, unique in the case.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub name: Option<String>,
    /// Instead of the case's.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub majorant: Option<MajorantChoice>,
    /// Instead of the case's; of samples, the rows of both stages, from the first on (default: all).
    #[serde(skip_serializing_if = "Option::is_none", default)]
    #[schemars(range(min = 1, max = MOST_DRAWS))]
    pub draws: Option<u64>,
    /// Instead of the case's.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    #[schemars(range(min = 1, max = MOST_DRAWS))]
    pub budget: Option<u64>,
    /// Instead of the case's.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub bias_bound: Option<BiasBound>,
    /// Instead of the case's.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    #[schemars(range(min = 0, max = 1))]
    pub tolerance: Option<f64>,
    /// Instead of the case's.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    #[schemars(range(min = 8, max = 53))]
    pub resolution_bits: Option<u32>,
    /// The verdict that is as it should be (default: computed from the claims).
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub expect: Option<Expectation>,
    /// Planted faults, laid in this order.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub fault: Option<Faults>,
    /// This setting hides the planted fault from the plain statistical tests; `expect` says what still sees it, if anything.
    #[serde(rename = "innocent", skip_serializing_if = "std::ops::Not::not", default)]
    pub masks_fault: bool,
    /// Claims withdrawn.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub without: Vec<Claim>,
    /// Instead of the case's.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub agree: Option<Vec<Agreement>>,
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
    /// What it says.
    pub case: Case,
    /// Whether its subject came from elsewhere, and along which ray.
    checked: Option<Option<usize>>,
}

impl CaseFile {
    /// Reads and parses `path`.
    ///
    /// # Errors
    /// If the file cannot be read or does not say a case.
    pub fn load(path: &Path) -> Result<Self, CaseError> {
        let text = surroundings::read_text(path, MAX_BYTES as u64)?;
        Self::parse(path, text)
    }

    /// A case that is not in a file: `path` is the name to show, and relative names are relative to its folder.
    ///
    /// # Errors
    /// If the text does not say a case.
    pub fn parse(path: &Path, text: impl Into<String>) -> Result<Self, CaseError> {
        let source = Source::new(path.display().to_string(), text)?;
        let case = source.read().map_err(|found| brought::located(&source, found))?;
        Ok(Self { path: path.to_path_buf(), source, case, checked: None })
    }
}

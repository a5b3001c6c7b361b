use super::rows;
use crate::kind::{Outline, SampleArguments, SamplesSpec};
use crate::samples::{Place, RowFormat};
use freepath_formats::Format;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A file of categories, numbered from 0, that any program has drawn: the first third of its rows, in drawing order, is stage 1, the rest stage 2, and
/// all are judged.
///
/// Target: the table of the scene.
/// Range:  the categories that have a weight.
/// Cost:   not known.
/// Needs:  `.npy`, `.csv`, `.txt` or `.f64`.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DiscreteSamples {
    /// Its name, from the folder of the case.
    pub file: String,
    /// The column of categories, by name or by number from 0 (default: the only one).
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub column: Option<String>,
    /// Its format (default: as the ending of its name tells).
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub format: Option<Format>,
}

impl SamplesSpec for DiscreteSamples {
    fn file(&self) -> &str {
        &self.file
    }
    fn rows(&self, _: &Outline) -> RowFormat {
        rows(Place::stated(self.column.as_deref()))
    }
    fn format(&self) -> Option<Format> {
        self.format
    }
    fn from_arguments(arguments: SampleArguments) -> Result<Self, &'static str> {
        let SampleArguments { file, column, format, .. } = arguments.without_paths()?;
        Ok(Self { file, column, format })
    }
}

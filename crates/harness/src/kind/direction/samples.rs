use super::rows;
use crate::kind::{Outline, SampleArguments, SamplesSpec};
use crate::samples::RowFormat;
use freepath_formats::Format;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A file of directions that any program has drawn, in the columns `x`, `y` and `z`: the first third of its rows, in drawing order,
/// is stage 1, the rest stage 2, and all are judged.
///
/// Target: the law of the scene.
/// Range:  its support.
/// Cost:   not known.
/// Needs:  `.npy`, `.csv`, `.txt` or `.f64`; without names, three columns; float32 is judged with a tolerance of 6e-8.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DirectionSamples {
    /// Its name, from the folder of the case.
    pub file: String,
    /// Its format (default: as the ending of its name tells).
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub format: Option<Format>,
}

impl SamplesSpec for DirectionSamples {
    fn file(&self) -> &str {
        &self.file
    }
    fn rows(&self, _: &Outline) -> RowFormat {
        rows()
    }
    fn format(&self) -> Option<Format> {
        self.format
    }
    fn from_arguments(arguments: SampleArguments) -> Result<Self, &'static str> {
        let SampleArguments { file, column, format, .. } = arguments.without_paths()?;
        if column.is_some() {
            return Err("cannot use --column: a direction has three (x, y, z)");
        }
        Ok(Self { file, format })
    }
}

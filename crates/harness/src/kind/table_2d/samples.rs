use super::rows;
use crate::kind::{Outline, SampleArguments, SamplesSpec};
use crate::samples::RowFormat;
use freepath_formats::Format;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A file of places that any program has drawn, in the columns `x` and `y`: the first third of its rows, in drawing order,
/// is stage 1, the rest stage 2, and all are judged.
///
/// Target: the table of the scene.
/// Range:  the rectangle.
/// Cost:   not known.
/// Needs:  `.npy`, `.csv`, `.txt` or `.f64`; without names, two columns; float32 is judged with a tolerance of 6e-8.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Table2dSamples {
    /// Its name, from the folder of the case.
    pub file: String,
    /// Its format (default: as the ending of its name tells).
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub format: Option<Format>,
}

impl SamplesSpec for Table2dSamples {
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
            return Err("cannot use --column: a place has two (x, y)");
        }
        Ok(Self { file, format })
    }
}

use crate::kind::{Outline, SampleArguments, SamplesSpec};
use crate::samples::RowFormat;
use freepath_formats::Format;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

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
    /// Its format (default: as the ending of its name tells).
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub format: Option<Format>,
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
        let arguments = arguments.without_paths()?;
        if arguments.column.is_some() {
            return Err("cannot use --column: chromatic samples have the columns t, event, w0, w1, ..");
        }
        let SampleArguments { file, format, .. } = arguments;
        Ok(Self { file, format })
    }
}

use crate::kind::{Outline, SampleArguments, SamplesSpec};
use crate::samples::{Escape, EscapeRule, Place, RowFormat};
use freepath_formats::Format;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

fn by_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

/// A file of free paths that any program has drawn: the first third of its rows, in drawing order, is stage 1, the rest
/// stage 2, and all are judged.
///
/// ```text
/// t as drawn, infinity for an escape; t >= length, NaN or some value, such as -1, if it is declared so
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
    /// The definition of an escape.
    #[serde(skip_serializing_if = "by_default", default)]
    #[schemars(extend("default" = "infinity"))]
    pub escape: Escape,
    /// Its format (default: as the ending of its name tells).
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub format: Option<Format>,
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
    fn weighted(&self) -> bool {
        self.weight.is_some()
    }
    fn from_arguments(arguments: SampleArguments) -> Result<Self, &'static str> {
        let SampleArguments { file, column, weight, escape, format } = arguments;
        Ok(Self { file, column, weight, escape, format })
    }
}

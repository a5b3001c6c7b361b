use super::named;
use crate::number;
use crate::repeat::{flag, name};
use clap::Args;
use freepath_formats::Format;
use freepath_harness::kind::SampleArguments;
use freepath_harness::samples::Escape;

/// How files of samples are read and judged, as `check` and `agree` share it.
#[derive(Args, Debug)]
pub(crate) struct Samples {
    /// The column of the draws, by name or by number from 0 [default: the only one].
    #[arg(long, value_name = "NAME")]
    column: Option<String>,
    /// The free paths that are escapes: infinity; at_length, the length of the ray or beyond; nan; or a value, such as value:-1.
    #[arg(long, value_name = "AT", default_value = "infinity")]
    escape: Escape,
    /// npy, csv, txt or f64 [default: as the ending of the name tells; f64 where standard input is read].
    #[arg(long, value_name = "FORMAT", value_parser = named::<Format>)]
    format: Option<Format>,
    /// Judge so many draws of a file, from the first on [default: all]; needed where standard input is read.
    #[arg(long, value_name = "N", value_parser = number::draws)]
    pub(crate) draws: Option<u64>,
    /// Samples may be off by so much in every claim [default: the case's if there is one, else 6e-8 if they are float32, else 0].
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    pub(crate) tolerance: Option<f64>,
}

impl Samples {
    /// Those of one file.
    pub(crate) fn arguments(&self, file: &str, weight: Option<&String>) -> SampleArguments {
        let Self { column, escape, format, .. } = self;
        SampleArguments {
            file: file.to_string(),
            column: column.clone(),
            weight: weight.cloned(),
            escape: *escape,
            format: *format,
        }
    }

    /// The words that say so again, as far as something else is the default.
    pub(crate) fn words(&self, weight: Option<&String>) -> Vec<String> {
        let Self { column, escape, format, draws, tolerance } = self;
        let escape = Some(escape).filter(|&escape| *escape != Escape::default());
        let words = [
            column.as_ref().map(|column| flag("column", column)),
            weight.map(|weight| flag("weight", weight)),
            escape.map(|escape| flag("escape", &escape.to_string())),
            format.as_ref().map(|format| flag("format", &name(format))),
            draws.map(|n| format!("--draws {n}")),
            tolerance.map(|x| format!("--tolerance {x:e}")),
        ];
        words.into_iter().flatten().collect()
    }
}

use super::{Output, named};
use crate::number;
use clap::Args;
use clap::builder::PossibleValuesParser;
use freepath_formats::Format;
use freepath_harness::experiment::Declared;
use freepath_harness::samples::Escape;

/// The kinds of which two files can be compared without a truth.
pub(crate) const COMPARED: [&str; 3] = ["free_path", "transmittance", "estimate"];

/// `freepath agree`.
#[derive(Args, Debug)]
pub(crate) struct Agree {
    /// A file of samples that any program has drawn: .npy, .csv, .txt or .f64.
    #[arg(value_name = "A")]
    pub(crate) a: String,
    /// Another one, which should have the same law, or the same mean.
    #[arg(value_name = "B")]
    pub(crate) b: String,
    /// The kind of the samples: laws of free paths are compared, and means of all others.
    #[arg(long = "as", value_name = "KIND", value_parser = PossibleValuesParser::new(COMPARED))]
    pub(crate) kind: String,
    /// The length of the ray; needed for free paths.
    #[arg(long, value_name = "L", value_parser = number::length, required_if_eq("kind", "free_path"))]
    pub(crate) length: Option<f64>,
    /// The column of the draws in both, by name or by number from 0 [default: the only one].
    #[arg(long, value_name = "NAME")]
    pub(crate) column: Option<String>,
    /// The free paths that are escapes: infinity; at_length, the length of the ray or beyond; nan; or a value, such as value:-1.
    #[arg(long, value_name = "AT", default_value = "infinity")]
    pub(crate) escape: Escape,
    /// npy, csv, txt or f64 [default: as the endings of the names tell].
    #[arg(long, value_name = "FORMAT", value_parser = named::<Format>)]
    pub(crate) format: Option<Format>,
    /// Compare so many draws of each, from the first on [default: all].
    #[arg(long, value_name = "N", value_parser = number::draws)]
    pub(crate) draws: Option<u64>,
    /// Samples may be off by so much [default: 6e-8 if they are float32, else 0].
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    pub(crate) tolerance: Option<f64>,
    /// What is known of the estimates, which are then held to it: range:LOW,HIGH, or noise_free; may be given more than once.
    #[arg(long, value_name = "WHAT")]
    pub(crate) declare: Vec<Declared>,
    /// The destination of the results.
    #[command(flatten)]
    pub(crate) output: Output,
}

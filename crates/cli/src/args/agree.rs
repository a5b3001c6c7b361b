use super::{Output, Samples};
use crate::number;
use clap::Args;
use clap::builder::PossibleValuesParser;
use freepath_harness::experiment::Declared;

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
    /// How they are read and judged.
    #[command(flatten)]
    pub(crate) reading: Samples,
    /// What is known of the estimates, which are then held to it: range:LOW,HIGH, or noise_free; may be given more than once.
    #[arg(long, value_name = "WHAT")]
    pub(crate) declare: Vec<Declared>,
    /// The destination of the results.
    #[command(flatten)]
    pub(crate) output: Output,
}

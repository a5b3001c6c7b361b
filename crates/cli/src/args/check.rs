use super::{Output, Samples, named};
use clap::Args;
use clap::builder::PossibleValuesParser;
use freepath_harness::case::KINDS;
use freepath_harness::experiment::Declared;
use freepath_statistics::claim::Withdrawal;
use std::path::PathBuf;

/// `freepath check`.
#[derive(Args, Debug)]
pub(crate) struct Check {
    /// A file of samples that any program has drawn: .npy, .csv, .txt or .f64; `-` is standard input.
    #[arg(value_name = "SAMPLES", allow_hyphen_values = true)]
    pub(crate) samples: String,
    /// The case whose medium they were drawn in; its subjects are left out.
    #[arg(long, value_name = "CASE")]
    pub(crate) case: PathBuf,
    /// The kind of the samples.
    #[arg(long = "as", value_name = "KIND", value_parser = PossibleValuesParser::new(KINDS.iter().map(|kind| kind.name)))]
    pub(crate) kind: String,
    /// How they are read and judged.
    #[command(flatten)]
    pub(crate) reading: Samples,
    /// The column of the statistical weights of free paths.
    #[arg(long, value_name = "NAME")]
    pub(crate) weight: Option<String>,
    /// Bits of the numbers, for the test of ties [default: the case's, else 24 if they are float32, else 53].
    #[arg(long, value_name = "N")]
    pub(crate) resolution_bits: Option<u32>,
    /// What is known of the estimates or weights, which are then held to it: range:LOW,HIGH, noise_free, binary, own_mean:X, second_moment:X, or replicates:N, rows in independent groups of N; may be given more than once.
    #[arg(long, value_name = "WHAT")]
    pub(crate) declare: Vec<Declared>,
    /// Claims withdrawn, such as independent, truth; may be given more than once.
    #[arg(long, value_name = "CLAIM", value_delimiter = ',', value_parser = named::<Withdrawal>)]
    pub(crate) without: Vec<Withdrawal>,
    /// The ray that they were drawn along, from 0, if the case has several.
    #[arg(long, value_name = "I")]
    pub(crate) ray: Option<usize>,
    /// Let the case name files outside its own folder.
    #[arg(long)]
    pub(crate) allow_paths: bool,
    /// The destination of the results.
    #[command(flatten)]
    pub(crate) output: Output,
}

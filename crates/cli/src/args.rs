//! What the command line takes.

use crate::number;
use clap::builder::PossibleValuesParser;
use clap::{Args, Parser, Subcommand, ValueEnum};
use freepath_formats::Format;
use freepath_harness::kind::KINDS;
use freepath_harness::samples::Escape;
use std::path::PathBuf;

/// Statistical verification of free-path samplers and transmittance estimators.
#[derive(Debug, Parser)]
#[command(name = "freepath", version, max_term_width = 100, after_help = EXIT_CODES)]
pub(crate) struct Command {
    /// What to do.
    #[command(subcommand)]
    pub(crate) verb: Verb,
    /// When to use colour; the variables NO_COLOR and CLICOLOR_FORCE count for `auto`.
    #[arg(long, global = true, value_name = "WHEN", default_value = "auto")]
    pub(crate) color: When,
}

const EXIT_CODES: &str = "Exit codes: 0 everything as expected, 1 something is not, 2 unusable input, 3 trouble while running, \
                          4 something is inconclusive and nothing worse, 130 interrupted.";

/// The commands.
#[derive(Debug, Subcommand)]
pub(crate) enum Verb {
    /// Run cases and write a report.
    Run(Run),
    /// Judge a file of samples against the medium of a case, and write a report.
    Check(Check),
    /// Print and plot the medium of cases: mu, majorant, tau and T.
    Medium(Medium),
    /// Bound the bias of subjects far below the noise, by scrambled Sobol points.
    Microscope(Microscope),
    /// Find how many draws each planted fault needs to be seen, and what sees it.
    Power(Power),
    /// List every name that a case can use, and every test and reason.
    List(List),
    /// Tell all about one name of the list.
    Describe(Describe),
    /// Print the JSON schema of a case.
    Schema,
    /// Write the report of results once more, without drawing.
    Report(Report),
    /// Run right subjects again and again: how often do they raise a false alarm?
    Soak(Soak),
}

/// `freepath run`.
#[derive(Args, Debug)]
pub(crate) struct Run {
    /// Case files, or folders of them, searched recursively for .json and .jsonc.
    #[arg(value_name = "PATH", default_value = "cases")]
    pub(crate) paths: Vec<PathBuf>,
    /// What is drawn.
    #[command(flatten)]
    pub(crate) sampling: Sampling,
    /// Where results go.
    #[command(flatten)]
    pub(crate) output: Output,
}

/// `freepath power`.
#[derive(Args, Debug)]
pub(crate) struct Power {
    /// Case files, or folders of them, searched recursively for .json and .jsonc.
    #[arg(value_name = "PATH", default_value = "cases/controls")]
    pub(crate) paths: Vec<PathBuf>,
    /// Print the table in Markdown, as in docs/power.md.
    #[arg(long, conflicts_with = "json")]
    pub(crate) markdown: bool,
    /// What is drawn.
    #[command(flatten)]
    pub(crate) sampling: Sampling,
    /// Where results go.
    #[command(flatten)]
    pub(crate) output: Output,
}

/// Which subjects of the cases are drawn, and how often.
#[derive(Args, Debug)]
pub(crate) struct Sampling {
    /// The seed of all random numbers.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(crate) seed: u64,
    /// Draws of every subject, whatever its case says; 1e6 may be written.
    #[arg(long, value_name = "N", value_parser = number::draws, conflicts_with_all = ["quick", "thorough"])]
    pub(crate) draws: Option<u64>,
    /// A tenth of the draws.
    #[arg(long, conflicts_with = "thorough")]
    pub(crate) quick: bool,
    /// Ten times the draws.
    #[arg(long)]
    pub(crate) thorough: bool,
    /// Only subjects whose id, name, case or file holds this text, or matches it if it has a `*`.
    #[arg(long, value_name = "TEXT")]
    pub(crate) filter: Option<String>,
    /// Let cases name files outside their own folder.
    #[arg(long)]
    pub(crate) allow_paths: bool,
    /// Let cases start programs, which can do whatever you can.
    #[arg(long)]
    pub(crate) allow_commands: bool,
    /// Kill a program after so much silence, or ten times as much in all [default: the case's, else 60].
    #[arg(long, value_name = "SECONDS", value_parser = number::seconds, requires = "allow_commands")]
    pub(crate) timeout: Option<f64>,
}

/// Where the results of a run go, and how fast.
#[derive(Args, Debug)]
pub(crate) struct Output {
    /// Worker threads [default: one per CPU]; results do not depend on it.
    #[arg(long, value_name = "N", value_parser = number::jobs)]
    pub(crate) jobs: Option<usize>,
    /// The folder that results are written to.
    #[arg(long, value_name = "DIR", default_value = "reports")]
    pub(crate) out: PathBuf,
    /// Print the JSON of the results instead of a line per subject.
    #[arg(long)]
    pub(crate) json: bool,
    /// Show no progress, and only what is not as expected.
    #[arg(long)]
    pub(crate) quiet: bool,
}

/// `freepath check`.
#[derive(Args, Debug)]
pub(crate) struct Check {
    /// A file of samples that any program has drawn: .npy, .csv, .txt or .f64; `-` is standard input.
    #[arg(value_name = "SAMPLES", allow_hyphen_values = true)]
    pub(crate) samples: String,
    /// The case whose medium they were drawn in; its subjects are left out.
    #[arg(long, value_name = "CASE")]
    pub(crate) case: PathBuf,
    /// What they are.
    #[arg(long = "as", value_name = "KIND", value_parser = PossibleValuesParser::new(KINDS.iter().map(|kind| kind.name)))]
    pub(crate) kind: String,
    /// The column of the draws, by name or by number from 0 [default: the only one].
    #[arg(long, value_name = "NAME")]
    pub(crate) column: Option<String>,
    /// The column of the statistical weights of free paths.
    #[arg(long, value_name = "NAME")]
    pub(crate) weight: Option<String>,
    /// Which free paths are escapes: those at infinity, or those at the length of the ray or beyond.
    #[arg(long, value_name = "AT", value_parser = named::<Escape>, default_value = "infinity")]
    pub(crate) escape: Escape,
    /// npy, csv, txt or f64 [default: as the ending of the name tells; f64 on standard input].
    #[arg(long, value_name = "FORMAT", value_parser = named::<Format>)]
    pub(crate) format: Option<Format>,
    /// Judge so many draws, from the first on [default: all]; needed on standard input.
    #[arg(long, value_name = "N", value_parser = number::draws)]
    pub(crate) draws: Option<u64>,
    /// Samples may be off by so much in every claim [default: the case's, else 6e-8 if they are float32, else 0].
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    pub(crate) tolerance: Option<f64>,
    /// Bits of the numbers, for the test of ties [default: the case's, else 24 if they are float32, else 53].
    #[arg(long, value_name = "N")]
    pub(crate) resolution_bits: Option<u32>,
    /// The ray that they were drawn along, from 0, if the case has several.
    #[arg(long, value_name = "I")]
    pub(crate) ray: Option<usize>,
    /// Let the case name files outside its own folder.
    #[arg(long)]
    pub(crate) allow_paths: bool,
    /// Where results go.
    #[command(flatten)]
    pub(crate) output: Output,
}

/// A value that a case would name.
fn named<T: serde::de::DeserializeOwned>(text: &str) -> Result<T, String> {
    serde_json::from_value(text.into()).map_err(|why| why.to_string())
}

/// `freepath medium`.
#[derive(Args, Debug)]
pub(crate) struct Medium {
    /// Case files, or folders of them.
    #[arg(value_name = "CASE", required = true)]
    pub(crate) cases: Vec<PathBuf>,
    /// The folder that the plots are written to.
    #[arg(long, value_name = "DIR", default_value = "reports/media")]
    pub(crate) out: PathBuf,
    /// Rows of the table along the ray.
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub(crate) rows: u32,
    /// Print JSON: the medium as results.json has it.
    #[arg(long)]
    pub(crate) json: bool,
    /// Let cases name files outside their own folder.
    #[arg(long)]
    pub(crate) allow_paths: bool,
}

/// `freepath microscope`.
#[derive(Args, Debug)]
pub(crate) struct Microscope {
    /// Case files, or folders of them.
    #[arg(value_name = "CASE", required = true)]
    pub(crate) paths: Vec<PathBuf>,
    /// Only subjects whose id, name, case or file holds this text, or matches it if it has a `*`.
    #[arg(long, value_name = "TEXT")]
    pub(crate) filter: Option<String>,
    /// Points of a net: a power of 2 up to 65536.
    #[arg(long, value_name = "N", default_value = "65536", value_parser = number::points)]
    pub(crate) points: u32,
    /// Independent scrambles.
    #[arg(long, value_name = "N", default_value_t = 24, value_parser = clap::value_parser!(u32).range(2..=10_000))]
    pub(crate) scrambles: u32,
    /// The seed of all scrambles.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(crate) seed: u64,
    /// Worker threads [default: one per CPU]; results do not depend on it.
    #[arg(long, value_name = "N", value_parser = number::jobs)]
    pub(crate) jobs: Option<usize>,
    /// Let cases name files outside their own folder.
    #[arg(long)]
    pub(crate) allow_paths: bool,
}

/// `freepath soak`.
#[derive(Args, Debug)]
pub(crate) struct Soak {
    /// Case files, or folders of them; of their subjects, those without a fault that should pass.
    #[arg(value_name = "PATH", default_value = "cases", conflicts_with = "quick")]
    pub(crate) paths: Vec<PathBuf>,
    /// How many full judgements, each on a seed of its own.
    #[arg(long, value_name = "N", default_value_t = 2000, value_parser = number::runs)]
    pub(crate) runs: u64,
    /// The seed from which each run has its own.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(crate) seed: u64,
    /// Draws of every subject [default: 16384, a block; with --quick what the built-in cases say].
    #[arg(long, value_name = "N", value_parser = number::draws)]
    pub(crate) draws: Option<u64>,
    /// The family-wise error of both stages; several decide the same draws.
    #[arg(long, value_name = "P", default_values_t = [1e-3], value_parser = number::level)]
    pub(crate) level: Vec<f64>,
    /// A small built-in selection of cases, with draws enough for every test.
    #[arg(long)]
    pub(crate) quick: bool,
    /// Worker threads [default: one per CPU]; results do not depend on it.
    #[arg(long, value_name = "N", value_parser = number::jobs)]
    pub(crate) jobs: Option<usize>,
    /// The folder that soak.json is written to.
    #[arg(long, value_name = "DIR", default_value = "reports")]
    pub(crate) out: PathBuf,
    /// Only subjects whose id, name, case or file holds this text, or matches it if it has a `*`.
    #[arg(long, value_name = "TEXT")]
    pub(crate) filter: Option<String>,
    /// Print soak.json instead of tables.
    #[arg(long)]
    pub(crate) json: bool,
    /// Show no progress.
    #[arg(long)]
    pub(crate) quiet: bool,
    /// Let cases name files outside their own folder.
    #[arg(long)]
    pub(crate) allow_paths: bool,
}

/// `freepath list`.
#[derive(Args, Debug)]
pub(crate) struct List {
    /// As JSON.
    #[arg(long)]
    pub(crate) json: bool,
    /// As a page in Markdown, with parameters and details: docs/reference.md.
    #[arg(long, conflicts_with = "json")]
    pub(crate) markdown: bool,
}

/// `freepath describe`.
#[derive(Args, Debug)]
pub(crate) struct Describe {
    /// A name of `freepath list`.
    pub(crate) name: String,
}

/// `freepath report`.
#[derive(Args, Debug)]
pub(crate) struct Report {
    /// The results.json of a run.
    pub(crate) results: PathBuf,
    /// The folder that the report is written to [default: that of the results].
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
}

/// When to use colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum When {
    /// On a terminal.
    Auto,
    /// Always.
    Always,
    /// Never.
    Never,
}

//! The arguments of the command line.

use crate::number;
use clap::{Args, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;

mod agree;
mod check;
mod microscope;
mod samples;
mod soak;

pub(crate) use agree::Agree;
pub(crate) use check::Check;
pub(crate) use microscope::Microscope;
pub(crate) use samples::Samples;
pub(crate) use soak::Soak;

/// Statistical verification of Monte Carlo samplers and estimators.
#[derive(Debug, Parser)]
#[command(name = "freepath", version, max_term_width = 100, after_help = EXIT_CODES)]
pub(crate) struct Command {
    /// The subcommand.
    #[command(subcommand)]
    pub(crate) verb: Verb,
    /// Use of colour; the variables NO_COLOR and CLICOLOR_FORCE count for `auto`.
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
    /// Compare two files of samples, whose truth nobody knows, and write a report.
    Agree(Agree),
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
    /// The subjects drawn, and how often.
    #[command(flatten)]
    pub(crate) sampling: Sampling,
    /// The destination of the results.
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
    /// The subjects drawn, and how often.
    #[command(flatten)]
    pub(crate) sampling: Sampling,
    /// The destination of the results.
    #[command(flatten)]
    pub(crate) output: Output,
}

/// The subjects of the cases that are drawn, and how often.
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

/// The folder that results are written to if none is named.
pub(crate) const USUAL_FOLDER: &str = "reports";

/// The destination of a run's results, and its speed.
#[derive(Args, Debug)]
pub(crate) struct Output {
    /// Worker threads [default: one per CPU]; results do not depend on it.
    #[arg(long, value_name = "N", value_parser = number::jobs)]
    pub(crate) jobs: Option<usize>,
    /// The folder that results are written to.
    #[arg(long, value_name = "DIR", default_value = USUAL_FOLDER)]
    pub(crate) out: PathBuf,
    /// Print the JSON of the results instead of a line per subject.
    #[arg(long)]
    pub(crate) json: bool,
    /// Show no progress, and only what is not as expected.
    #[arg(long)]
    pub(crate) quiet: bool,
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

/// A value that a case would name.
fn named<T: serde::de::DeserializeOwned>(text: &str) -> Result<T, String> {
    serde_json::from_value(text.into()).map_err(|why| why.to_string())
}

/// Use of colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum When {
    /// On a terminal.
    Auto,
    /// Always.
    Always,
    /// Never.
    Never,
}

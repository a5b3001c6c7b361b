use crate::number;
use clap::Args;
use std::path::PathBuf;

/// `freepath soak`.
#[derive(Args, Debug)]
pub(crate) struct Soak {
    /// Case files, or folders of them; of their subjects, those without a fault that should pass.
    #[arg(value_name = "PATH", default_value = "cases", conflicts_with = "quick")]
    pub(crate) paths: Vec<PathBuf>,
    /// The number of full judgements, each on a seed of its own.
    #[arg(long, value_name = "N", default_value_t = 2000, value_parser = number::runs)]
    pub(crate) runs: u64,
    /// The seed from which each run has its own.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(crate) seed: u64,
    /// Draws of every subject [default: 16384, a block; with --quick what the built-in cases say].
    #[arg(long, value_name = "N", value_parser = number::draws)]
    pub(crate) draws: Option<u64>,
    /// The family-wise error of both stages; several decide the same draws.
    #[arg(long, value_name = "P", default_values_t = [7.07e-4], value_parser = number::level)]
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

use crate::number;
use clap::Args;
use std::path::PathBuf;

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

//! Measures the true level of every asymptotic p-value at the thresholds that a run uses, and prints a table in Markdown.
//!
//! A run of some 6,000 p-values reads them near 1e-7, where plain sampling needs 1e9 replicates. Here replicates lean towards
//! the tail and are weighted by their exact likelihood ratio.
//!
//! ```text
//! cargo run --release -p freepath-calibration --bin levels > docs/levels.md
//! ```

mod auxiliary;
mod exposure;
mod kolmogorov;
mod lag;
mod lookups;
mod means;
mod neyman;
mod null_positions;
mod order;
mod pairs;
mod pearson;
mod second_moment;
mod table;
mod too_even;
mod weighted;

use clap::Parser;
use std::process::ExitCode;
use table::Row;

/// The levels at which p-values are held to their word.
pub(crate) const LEVELS: [f64; 3] = [1e-3, 1e-5, 1e-7];

/// Measures the true level of every asymptotic p-value.
#[derive(Parser)]
struct Args {
    /// Replicates for each figure.
    #[arg(long, default_value_t = 16_384)]
    replicates: u64,
    /// The seed of all replicates.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Only tests whose name holds this text.
    #[arg(long, default_value = "")]
    only: String,
}

/// The replicates to measure with, and their seed.
#[derive(Clone, Copy)]
pub(crate) struct Effort {
    pub(crate) replicates: u64,
    pub(crate) seed: u64,
}

type Measure = fn(Effort) -> Vec<Row>;

const TESTS: [(&str, Measure); 14] = [
    ("chi_square", pearson::rows),
    ("too_even", too_even::rows),
    ("null_positions", null_positions::rows),
    ("exposure", exposure::rows),
    ("mean", means::rows),
    ("second_moment", second_moment::rows),
    ("lookups", lookups::rows),
    ("lag", lag::rows),
    ("pairs", pairs::rows),
    ("order", order::rows),
    ("auxiliary agree", auxiliary::rows),
    ("weighted", weighted::rows),
    ("neyman", neyman::rows),
    ("kolmogorov", kolmogorov::rows),
];

fn main() -> ExitCode {
    let args = Args::parse();
    let effort = Effort { replicates: args.replicates, seed: args.seed };
    let wanted = TESTS.iter().filter(|(name, _)| name.contains(&args.only));
    let rows: Vec<Row> = wanted.flat_map(|(_, measure)| measure(effort)).collect();
    table::print(&rows, &args.replicates);
    ExitCode::from(u8::from(!rows.iter().all(Row::kept)))
}

//! Measures the power at the errors that `detectable` tells, over a small grid, and prints a table in Markdown.
//!
//! ```text
//! cargo run --release -p freepath-calibration --bin detectable
//! ```

use clap::Parser;
use freepath_calibration::finite::Finite;
use freepath_calibration::multinomial::counts;
use freepath_calibration::tail::Tail;
use freepath_draws::random::uniform;
use freepath_results::Reason;
use freepath_statistics::hypothesis::{MeanClaim, mean, whole_law};
use freepath_statistics::tally::{CellTally, PowerSums};
use freepath_statistics::{Detection, Evidence, Law, StageLevel};
use rand::Rng;

/// Measures the power of what `detectable` tells.
#[derive(Parser)]
struct Args {
    /// Replicates for each figure.
    #[arg(long, default_value_t = 4096)]
    replicates: u64,
    /// The seed of all replicates.
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

impl Args {
    /// The share of replicates of which both stages reject.
    fn power(&self, detection: Detection, stage: impl Fn(u64, &mut dyn Rng) -> Evidence + Sync) -> (f64, f64) {
        let rejects =
            |StageLevel { level, draws }, rng: &mut dyn Rng| stage(draws, rng).p.is_some_and(|p| !(p > level));
        let both = Tail::measure(self.seed, self.replicates, |rng| {
            let all = detection.stages.map(|level| rejects(level, rng));
            f64::from(u8::from(all == [true; 2]))
        });
        both.probability()
    }
}

fn main() {
    let args = Args::parse();
    println!("| error | draws | p-values | `detectable` | power |\n|---|---:|---:|---:|---:|");
    for p_values in [1, 1_000, 10_000] {
        let detection = |draws| Detection::among([p_values, p_values], [draws, 2 * draws]);
        let row = |error: &str, draws: u64, d: f64, (power, se): (f64, f64)| {
            println!("| {error} | {draws} | {p_values} | {d:.3e} | {power:.3} ± {se:.3} |");
        };
        for bias in [-1.0, 1.0] {
            let sign = if bias < 0.0 { "below" } else { "above" };
            let d = detection(16_384).mean(1.0 / 12f64.sqrt());
            row(
                &format!("uniform, {sign}"),
                16_384,
                d,
                args.power(detection(16_384), |n, rng| of_uniform(n, bias * d, rng)),
            );
            for (share, draws) in [(0.2, 16_384), (1e-3, 100_000), (3e-4, 100_000), (1e-4, 10_000)] {
                let d = detection(draws).share(share);
                let power = args.power(detection(draws), |n, rng| of_share(n, share, bias * d, rng));
                if share + bias * d > 0.0 {
                    row(&format!("0 or 1, {share:e}, {sign}"), draws, d, power);
                }
            }
        }
        let law = Law::new(1.0, 0.0, |t| 1.0 - 0.9 * t);
        for at in [0.1, 0.5, 0.9] {
            let (n, d) = (100_000, detection(100_000).distance() + law.mass(0));
            row(
                &format!("law, at F = {at}"),
                n,
                d,
                args.power(detection(n), |n, rng| of_law(&law, at, d, n, rng)),
            );
        }
    }
}

fn claim(expected: f64, binary: bool) -> MeanClaim {
    MeanClaim { expected, slack: 0.0, binary, range: None, variance: None, skewness: None }
}

fn of_uniform(n: u64, bias: f64, rng: &mut dyn Rng) -> Evidence {
    let draws: Vec<f64> = (0..n).map(|_| uniform(rng) + bias).collect();
    mean("mean", &PowerSums::of(0.5, &draws), &claim(0.5, false), Reason::Biased).0
}

fn of_share(n: u64, share: f64, bias: f64, mut rng: &mut dyn Rng) -> Evidence {
    let drawn = counts(n, &[1.0 - share - bias, share + bias], &mut rng);
    let sums = Finite::coin(share).sums(share, &[drawn[0], drawn[1]]);
    mean("mean", &sums, &claim(share, true), Reason::Biased).0
}

/// Draws whose distribution function is off by `d` where it is `at`, by as much less on the way there.
fn of_law(law: &Law, at: f64, d: f64, n: u64, mut rng: &mut dyn Rng) -> Evidence {
    let share = |k: usize| law.mass(k) * if law.cdf(k) < at { 1.0 + d / at } else { 1.0 - d / (1.0 - at) };
    let mut shares: Vec<f64> = (0..law.cells()).map(share).collect();
    shares.push(1.0 - shares.iter().sum::<f64>());
    let mut drawn = counts(n, &shares, &mut rng);
    let escapes = drawn.pop().unwrap_or(0);
    whole_law(law, &CellTally { cells: drawn, escapes, ..CellTally::default() }, Reason::WrongLaw)
}

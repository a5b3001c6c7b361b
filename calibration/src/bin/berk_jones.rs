//! Quantiles of the Berk-Jones statistic of the harness, and the level that its p-value then has.
//!
//! ```text
//! cargo run --release -p freepath-calibration --bin berk_jones -- table --replicates 100000 \
//!     > crates/statistics/src/special/berk_jones/quantiles.rs
//! cargo run --release -p freepath-calibration --bin berk_jones -- check --replicates 20000
//! ```
//!
//! `table` simulates the 512 smallest and 512 largest of m uniforms exactly, and the counts between by exact binomials at edges that lie
//! closer than those of any law: each 0.1 % farther from its end than the last. So the quantiles are those of the largest statistic
//! that any cells can give. `check` does the same with the edges that laws have and prints how often p is small.
//! Time: some 10 ms for each replicate of all rows, over the number of threads.

use clap::{Parser, ValueEnum};
use freepath_statistics::hypothesis::BerkJones;
use freepath_statistics::special::berk_jones_sf;
use rand::{RngExt, SeedableRng};
use rand_distr::{Binomial, Distribution};
use rand_xoshiro::Xoshiro256PlusPlus;
use rayon::prelude::*;

const KEPT: usize = freepath_statistics::tally::KEPT;

/// The p-values of the columns.
const LEVELS: [f64; 16] =
    [0.95, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001];

/// The draws of the rows.
const DRAWS: [u64; 10] =
    [100, 300, 1000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000, 1_000_000_000, 1_000_000_000_000];

#[derive(Clone, Copy, ValueEnum)]
enum What {
    Table,
    Check,
}

/// Calibrates the Berk-Jones statistic.
#[derive(Parser)]
struct Args {
    what: What,
    /// Null samples for each m.
    #[arg(long, default_value_t = 20_000)]
    replicates: u64,
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

fn main() {
    let args = Args::parse();
    match args.what {
        What::Table => table(&args),
        What::Check => check(&args),
    }
}

fn table(args: &Args) {
    println!(
        "//! Made by `calibration/src/bin/berk_jones.rs table --replicates {} --seed {}`.\n",
        args.replicates, args.seed
    );
    println!("/// The p-values of the columns.\npub(super) const LEVELS: [f64; {}] = {LEVELS:?};\n", LEVELS.len());
    println!("/// m, and the statistic that is reached with each of these p-values.");
    println!("#[rustfmt::skip]\npub(super) const ROWS: [(f64, [f64; {}]); {}] = [", LEVELS.len(), DRAWS.len());
    for m in DRAWS {
        let statistics = sorted(args, m, &dense(m));
        let at = |p: &f64| {
            let rank = (p * args.replicates as f64).round() as usize;
            format!("{:.4}", statistics[statistics.len() - rank])
        };
        println!("    ({m:e}, [{}]),", LEVELS.iter().map(at).collect::<Vec<_>>().join(", "));
    }
    println!("];");
}

/// For each m and kind of edges: the share of p-values at or below some levels, over those levels.
fn check(args: &Args) {
    println!("{:>6} {:>28}   p <= 0.5   0.1    0.01   0.001  (share / level)", "m", "edges");
    for m in DRAWS {
        for (name, edges) in
            [("dense", dense(m)), ("16385 equal", equal(16_385)), ("16385 of exp(-7 t)", falling(7.0))]
        {
            let statistics = sorted(&Args { seed: args.seed + 1000, ..*args }, m, &edges);
            let p: Vec<f64> = statistics.iter().map(|&x| berk_jones_sf(m, x)).collect();
            let ratio = |level: &f64| {
                let below = p.iter().filter(|p| **p <= *level).count();
                format!("{:6.3}", below as f64 / (level * p.len() as f64))
            };
            println!(
                "{m:>6e} {name:>28}   {}",
                [0.5, 0.1, 0.01, 0.001].iter().map(ratio).collect::<Vec<_>>().join(" ")
            );
        }
    }
}

/// Places on both sides of 1/2, each 0.1 % farther from its end than the last, from half of the kept share on.
fn dense(m: u64) -> Vec<f64> {
    let mut near = vec![];
    let mut u = 0.5 * KEPT as f64 / m as f64;
    while u < 0.5 {
        near.push(u);
        u *= 1.001;
    }
    let far: Vec<f64> = near.iter().rev().map(|u| 1.0 - u).collect();
    near.into_iter().chain(far).collect()
}

fn equal(cells: u32) -> Vec<f64> {
    (1..cells).map(|k| f64::from(k) / f64::from(cells)).collect()
}

/// The edges of an exponential law cut at t = 1.
fn falling(rate: f64) -> Vec<f64> {
    equal(16_385).iter().map(|t| libm::expm1(-rate * t) / libm::expm1(-rate)).collect()
}

/// The statistics of all replicates, increasing; the same for any number of threads.
fn sorted(args: &Args, m: u64, edges: &[f64]) -> Vec<f64> {
    let one = |replicate: u64| {
        let seed = args.seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ (m << 24) ^ replicate;
        statistic(m, edges, &mut Xoshiro256PlusPlus::seed_from_u64(seed))
    };
    let mut all: Vec<f64> = (0..args.replicates).into_par_iter().map(one).collect();
    all.sort_unstable_by(f64::total_cmp);
    all
}

/// The statistic of one sample of `m` uniforms.
fn statistic(m: u64, edges: &[f64], rng: &mut Xoshiro256PlusPlus) -> f64 {
    let mut statistic = BerkJones::new(m);
    let near = smallest(m, m, 1.0, rng);
    let kept = near.len() as u64;
    near.iter().enumerate().for_each(|(below, &u)| see(&mut statistic, below, u));
    if kept < m {
        let start = near[near.len() - 1];
        let far = smallest(m - kept, m - kept, 1.0 - start, rng);
        far.iter().enumerate().for_each(|(below, &u)| see(&mut statistic, below, u));
        let between = m - kept - far.len() as u64;
        middle(&mut statistic, (m, kept, between), (start, 1.0 - far[far.len() - 1]), edges, rng);
    }
    statistic.value()
}

fn see(statistic: &mut BerkJones, below: usize, u: f64) {
    statistic.see(below as f64 + 1.0, u, u);
    statistic.see(below as f64, u, u);
}

/// The smallest order statistics of `n` uniforms on [0, `width`], one after the other: the least of n is 1 - V^(1/n).
fn smallest(n: u64, most: u64, width: f64, rng: &mut Xoshiro256PlusPlus) -> Vec<f64> {
    let mut u = 0.0;
    (0..most.min(KEPT as u64))
        .map(|taken| {
            let least = -libm::expm1(libm::log1p(-rng.random::<f64>()) / (n - taken) as f64);
            u += (width - u) * least;
            u
        })
        .collect()
}

/// Counts at the edges between the kept draws.
fn middle(
    statistic: &mut BerkJones,
    (m, mut below, mut left): (u64, u64, u64),
    (mut start, end): (f64, f64),
    edges: &[f64],
    rng: &mut Xoshiro256PlusPlus,
) {
    for &u in edges {
        if u <= start {
            continue;
        }
        if u >= end {
            break;
        }
        let share = (u - start) / (end - start);
        let count = Binomial::new(left, share).map_or(0, |law| law.sample(rng));
        (below, left, start) = (below + count, left - count, u);
        if u < 0.5 {
            statistic.see(below as f64, u, u);
        } else {
            statistic.see((m - below) as f64, 1.0 - u, 1.0 - u);
        }
    }
}

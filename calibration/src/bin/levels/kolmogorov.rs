//! Kolmogorov-Smirnov: uniform draws with too many or too few below one of many points.

use crate::Effort;
use crate::table::Row;
use freepath_calibration::multinomial::quantile;
use freepath_calibration::tail::Tail;
use freepath_draws::random::uniform;
use freepath_statistics::special::ks_two_sided;

/// Points below which there may be too many or too few.
const POINTS: usize = 160;

pub(crate) fn rows(effort: Effort) -> Vec<Row> {
    let row = |n: usize| {
        let fewer = effort.replicates / (1 + n as u64 / 500);
        Row::new("kolmogorov", format!("{n} draws of a continuous law"), true, |level| {
            vec![tail(n, level, Effort { replicates: fewer, ..effort })]
        })
    };
    [10, 100, 1000, 5000].into_iter().map(row).collect()
}

/// Density below a point, and above it.
struct Step {
    at: f64,
    below: f64,
    above: f64,
}

fn tail(n: usize, level: f64, effort: Effort) -> Tail {
    let begin = quantile(|d| ks_two_sided(n as u64, d), level);
    let points = (1..POINTS).map(|k| k as f64 / POINTS as f64);
    let step = |(at, sign): (f64, f64)| Step {
        at,
        below: 1.0 + sign * begin / at,
        above: 1.0 - sign * begin / (1.0 - at),
    };
    let both = points.flat_map(|at| [(at, -1.0), (at, 1.0)]).map(step);
    let steps: Vec<Step> = both.filter(|step| step.below > 0.02 && step.above > 0.02).collect();
    Tail::measure(effort.seed, effort.replicates, |rng| {
        let step = &steps[(uniform(rng) * steps.len() as f64) as usize];
        let mass = step.at * step.below;
        let mut draw = || {
            let u = uniform(rng);
            if u < mass { u / step.below } else { step.at + (u - mass) / step.above }
        };
        let mut draws: Vec<f64> = (0..n).map(|_| draw()).collect();
        draws.sort_unstable_by(f64::total_cmp);
        if distance(&draws) >= begin { 1.0 / mixture(&steps, &draws) } else { 0.0 }
    })
}

/// The density of the draws under all steps alike, over that of uniform draws.
fn mixture(steps: &[Step], draws: &[f64]) -> f64 {
    let one = |step: &Step| {
        let below = draws.partition_point(|&u| u < step.at) as f64;
        libm::exp(below * libm::log(step.below) + (draws.len() as f64 - below) * libm::log(step.above))
    };
    steps.iter().map(one).sum::<f64>() / steps.len() as f64
}

fn distance(sorted: &[f64]) -> f64 {
    let n = sorted.len() as f64;
    let gap = |(i, u): (usize, f64)| {
        let (over, under) = ((i + 1) as f64 / n - u, u - i as f64 / n);
        if over > under { over } else { under }
    };
    sorted.iter().copied().enumerate().map(gap).fold(0.0, |a, b| if b > a { b } else { a })
}

//! Laws under weights: parts of the ray in each of which a draw has one of two weights.

use crate::Effort;
use crate::table::Row;
use freepath_calibration::multinomial::{Multinomial, quantile};
use freepath_calibration::tail::Tail;
use freepath_statistics::Law;
use freepath_statistics::hypothesis::{WeightedLaw, weighted};
use freepath_statistics::special::chi_square_sf;
use freepath_statistics::tally::{Bins, WeighedSums};

/// Two weights, and the share of the second.
#[derive(Clone, Copy)]
struct Weights {
    one: f64,
    other: f64,
    share: f64,
}

/// The ray in parts that expect as many draws each; a fifth of all draws reaches the end.
struct Ray {
    bins: Bins,
    law: WeightedLaw,
    weights: Weights,
    /// The draws of the one weight and of the other, part by part, and those that reach the end.
    cells: Multinomial,
}

const REACH_THE_END: f64 = 0.2;

impl Weights {
    fn moment(self, power: i32) -> f64 {
        (1.0 - self.share) * self.one.powi(power) + self.share * self.other.powi(power)
    }
}

impl Ray {
    fn new(parts: usize, each: f64, weights: Weights) -> Self {
        let bins = Bins::new(&Law::new(1.0, 0.0, |t| 1.0 - t), parts);
        let mean = weights.moment(1) * (1.0 - REACH_THE_END);
        let law = WeightedLaw::new(&bins, 0.0, |a, b| mean * (b - a));
        let rows = each * parts as f64 / (1.0 - REACH_THE_END);
        let part = bins.edges().windows(2).flat_map(|w| {
            let rows = rows * (1.0 - REACH_THE_END) * (w[1] - w[0]);
            [rows * (1.0 - weights.share), rows * weights.share]
        });
        let cells: Vec<f64> = part.chain([rows * REACH_THE_END]).collect();
        Self { law, weights, cells: Multinomial::expecting(&cells), bins }
    }

    fn sums(&self, counts: &[u64]) -> WeighedSums {
        let Weights { one, other, .. } = self.weights;
        let part = |pair: &[u64]| {
            let of = |power| pair[0] as f64 * f64::powi(one, power) + pair[1] as f64 * f64::powi(other, power);
            [of(1), of(2), of(3)]
        };
        WeighedSums::of_column(self.cells.n, counts.chunks_exact(2).map(part).collect())
    }

    fn tail(&self, level: f64, effort: Effort) -> Tail {
        let parts = self.bins.count();
        let begin = quantile(|x| chi_square_sf(parts as f64, x), level);
        let spread = self.cells.spread(begin / parts as f64);
        Tail::measure(effort.seed, effort.replicates, |rng| {
            let counts = spread.counts(rng);
            let evidence = weighted("weighted", &self.law, &self.sums(&counts), 0, parts);
            let there = evidence.p.is_some_and(|p| !(p > level));
            if there { libm::exp(spread.log_ratio(&counts)) } else { 0.0 }
        })
    }
}

pub(crate) fn rows(effort: Effort) -> Vec<Row> {
    let mut rows = Vec::new();
    for (test, parts) in [("weighted_16", 16), ("weighted_64", 64)] {
        let fewer = Effort { replicates: effort.replicates / if parts > 16 { 4 } else { 1 }, ..effort };
        for (one, other, share, each) in
            [(1.0, 1.0, 0.5, 110.0), (1.0, 4.0, 0.5, 200.0), (1.0, 8.0, 0.2, 1_900.0), (1.0, 20.0, 0.05, 8_000.0)]
        {
            let ray = Ray::new(parts, each, Weights { one, other, share });
            let setting =
                format!("{parts} parts expecting {each} draws, one of {:.0} of weight {other}", 1.0 / share);
            rows.push(Row::new(test, setting, true, |level| vec![ray.tail(level, fewer)]));
        }
    }
    rows
}

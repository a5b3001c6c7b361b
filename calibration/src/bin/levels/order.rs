//! Circular correlations at all lags: one lag, through chains whose neighbours attract or repel each other, as often as there are lags,
//! sides and series. What all lags together reject is at most that.

use crate::Effort;
use crate::lag::Chain;
use crate::table::Row;
use freepath_calibration::multinomial::quantile;
use freepath_calibration::tail::Tail;
use freepath_statistics::special::{pearson_cdf, pearson_sf};
use freepath_statistics::tally::{
    BlockRows, Circular, Escaped, Kept, MOST_ROWS, ScoreMoments, Sequence, SequencePart,
};

pub(crate) fn rows(effort: Effort) -> Vec<Row> {
    // Most collide; few collide, so that a product is as skew as the gate allows.
    let settings = [(1.6, 2048, true), (1.6, 16_384, true), (0.046, 2048, false)];
    let row = |(depth, draws, both): (f64, usize, bool)| {
        let chain = Chain::new(depth, draws);
        let fewer = Effort { replicates: effort.replicates / (1 + draws as u64 / 1000), ..effort };
        let setting = format!("depth {depth}, one lag of {draws} rows, times {}", 2 * draws);
        let signs = if both { vec![-1.0, 1.0] } else { vec![1.0] }; // the lower tail ends before it is reached
        Row::new("order", setting, true, |level| {
            signs.iter().map(|&sign| tail(&chain, sign, level, fewer)).collect()
        })
    };
    settings.into_iter().map(row).collect()
}

/// The share of `level` that one side has: at most, over all lags of ranks and of their distances from the median.
fn tail(chain: &Chain, sign: f64, level: f64, effort: Effort) -> Tail {
    let n = chain.draws as f64;
    let one = |skewness: f64, z: f64| if sign > 0.0 { pearson_sf(skewness, z) } else { pearson_cdf(skewness, -z) };
    let begin = quantile(|z| 2.0 * one(chain.skewness, z), level / n);
    let pull = chain.pull(sign, begin);
    Tail::measure(effort.seed, effort.replicates, |rng| {
        let (t, log_ratio) = chain.draw(&[pull], rng);
        let (skewness, z) = neighbours(&t);
        let there = 2.0 * n * one(skewness, sign * z) <= level && sign * z > 0.0;
        if there { n * libm::exp(log_ratio) } else { 0.0 }
    })
}

/// z at lag 1, and its skewness, of ranks among the rows.
fn neighbours(t: &[f64]) -> (f64, f64) {
    let kept = |values| Kept::Values { values, escapes: true };
    let mut sequence = Sequence::new(kept(Vec::new()), MOST_ROWS);
    let zeros = vec![0; t.len()]; // sums over all rows are not looked at
    let rows = BlockRows { nth: 0, scores: &zeros, escaped: Escaped::Never, kept: Some(kept(t.to_vec())) };
    sequence.fold(&SequencePart::of(rows));
    let scores = sequence.first().map(|first| first.scores).unwrap_or_default();
    let (n, [of, _]) = (t.len() as f64, Circular::of(&scores).both);
    let (spread, skewness) = (of.moments.spread(), ScoreMoments::skewness(&of.moments));
    let sum = of.moments.sum as f64;
    let z = (of.products[0] as f64 - sum * sum / n + spread / (n - 1.0)) * (n - 1.0).sqrt() / spread;
    (skewness * skewness / n.sqrt(), z)
}

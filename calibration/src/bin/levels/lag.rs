//! Lag 1: chains of free paths whose neighbours attract or repel each other, through the test itself.

use crate::Effort;
use crate::table::Row;
use freepath_calibration::multinomial::quantile;
use freepath_calibration::tail::Tail;
use freepath_estimators::Key;
use freepath_estimators::random::uniform;
use freepath_harness::evidence::Evidence;
use freepath_harness::law::Law;
use freepath_harness::special::pearson_two_sided;
use freepath_harness::tally::{CellTally, LagTally, Scores};
use freepath_harness::test::lag;
use rand::Rng;

pub(crate) fn rows(effort: Effort) -> Vec<Row> {
    let mut rows = Vec::new();
    for (draws, deep) in [(2001, false), (16_384, false), (2001, true), (16_384, true)] {
        let root = ((draws - 1) as f64).sqrt();
        let skewness = |depth: f64| {
            let s = Scores::new(&law(depth)).skewness();
            s * s / root
        };
        let depth = if deep { 8.0 } else { quantile(skewness, 0.0999) };
        let chain = Chain { depth, draws, skewness: skewness(depth) };
        let fewer = Effort { replicates: effort.replicates / (1 + draws as u64 / 2000), ..effort };
        let setting = format!("depth {depth:.4}, {draws} draws in a row, skewness {:.3}", chain.skewness);
        rows.push(Row::new("lag_1", setting, true, |level| {
            [-1.0, 1.0].map(|sign| chain.tail(sign, level, fewer)).into()
        }));
    }
    rows
}

/// A ray of length 1.
fn law(depth: f64) -> Law {
    Law::new(1.0, 0.0, |t| libm::exp(-depth * t))
}

struct Chain {
    depth: f64,
    draws: usize,
    skewness: f64,
}

impl Chain {
    fn tail(&self, sign: f64, level: f64, effort: Effort) -> Tail {
        let law = law(self.depth);
        let scores = Scores::new(&law);
        let begin = quantile(|z| pearson_two_sided(self.skewness, sign * z), level);
        let pull = self.pull(sign, begin, &law, &scores);
        Tail::measure(effort.seed, effort.replicates, |rng| {
            let (t, log_ratio) = self.draw(pull, rng);
            let evidence = judged(&law, &scores, &t);
            let there = evidence.statistic * sign > 0.0 && evidence.p.is_some_and(|p| !(p > level));
            if there { libm::exp(log_ratio) } else { 0.0 }
        })
    }

    /// The pull at which the mean of the statistic is where the tail begins, from few chains.
    fn pull(&self, sign: f64, begin: f64, law: &Law, scores: &Scores) -> f64 {
        let mean = |pull: f64| {
            let mut rng = Key { seed: 99, subject: 1, block: 0 }.rng();
            let one = |_| judged(law, scores, &self.draw(sign * pull, &mut rng).0).statistic * sign;
            (0..100).map(one).sum::<f64>() / 100.0
        };
        let (mut low, mut high) = (0.0, 1.0);
        while mean(high) < begin {
            (low, high) = (high, 2.0 * high);
        }
        for _ in 0..8 {
            let middle = 0.5 * (low + high);
            if mean(middle) < begin { low = middle } else { high = middle }
        }
        sign * 0.5 * (low + high)
    }

    /// A chain in which the next score s' has density in proportion to exp(pull s s'), and the log of its likelihood ratio.
    fn draw(&self, pull: f64, rng: &mut impl Rng) -> (Vec<f64>, f64) {
        let (atom, mut previous, mut log_ratio) = (libm::exp(-self.depth), 0.0, 0.0);
        let mut one = |_| {
            let lean = pull * previous;
            let inside = if lean.abs() < 1e-9 {
                1.0 - atom
            } else {
                libm::exp(-0.5 * lean) * libm::expm1(lean * (1.0 - atom)) / lean
            };
            let escape = 0.5 * (1.0 - atom);
            let outside = atom * libm::exp(lean * escape);
            let u = uniform(rng) * (inside + outside);
            let (t, score) = if u < inside {
                let rank =
                    if lean.abs() < 1e-9 { u } else { libm::log1p(u * lean * libm::exp(0.5 * lean)) / lean };
                (-libm::log1p(-rank) / self.depth, rank - 0.5)
            } else {
                (f64::INFINITY, escape)
            };
            log_ratio += libm::log(inside + outside) - lean * score;
            previous = score;
            if t <= 1.0 || t == f64::INFINITY { t } else { 1.0 }
        };
        let t = (0..self.draws).map(&mut one).collect();
        (t, log_ratio)
    }
}

fn judged(law: &Law, scores: &Scores, t: &[f64]) -> Evidence {
    let (mut cells, mut index, mut tally) = (CellTally::new(law), Vec::new(), LagTally::default());
    cells.observe(law, t, &mut index);
    tally.observe(scores, &index);
    lag(scores, &tally, &cells)
}

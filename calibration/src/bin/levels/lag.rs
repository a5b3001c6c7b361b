//! Lag 1, and lags 2 to 8: chains of free paths whose neighbours near and far attract or repel each other, through the tests
//! themselves.

use crate::Effort;
use crate::table::Row;
use freepath_calibration::direction::Direction;
use freepath_calibration::multinomial::quantile;
use freepath_calibration::tail::Tail;
use freepath_draws::Key;
use freepath_draws::random::uniform;
use freepath_statistics::hypothesis::{lag, lags};
use freepath_statistics::special::{chi_square_sf, pearson_two_sided};
use freepath_statistics::tally::{CellTally, LAGS, LagTally, Scores};
use freepath_statistics::{Evidence, Law};
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
    rows.extend([false, true].map(|deep| further(deep, effort)));
    rows
}

/// Lags 2 to 8 of one block, at the gate or deep in a medium.
fn further(deep: bool, effort: Effort) -> Row {
    let draws = 16_384;
    let skewness = |depth: f64| {
        let s = Scores::new(&law(depth)).skewness();
        s * s / ((draws - 8) as f64).sqrt()
    };
    let depth = if deep { 8.0 } else { quantile(skewness, 0.0299) };
    let chain = Chain { depth, draws, skewness: skewness(depth) };
    let setting = format!("depth {depth:.4}, {draws} draws in a row, skewness {:.3}", chain.skewness);
    let fewer = Effort { replicates: effort.replicates / 8, ..effort };
    Row::new("lag_2_to_8", setting, true, |level| vec![chain.further(level, fewer)])
}

/// A ray of length 1.
fn law(depth: f64) -> Law {
    Law::new(1.0, 0.0, |t| libm::exp(-depth * t))
}

/// Free paths in a row whose neighbours attract or repel each other.
pub(crate) struct Chain {
    depth: f64,
    pub(crate) draws: usize,
    /// Of a sum of products of neighbours.
    pub(crate) skewness: f64,
}

impl Chain {
    pub(crate) fn new(depth: f64, draws: usize) -> Self {
        let skewness = Scores::new(&law(depth)).skewness();
        Self { depth, draws, skewness: skewness * skewness / (draws as f64).sqrt() }
    }

    fn tail(&self, sign: f64, level: f64, effort: Effort) -> Tail {
        let law = law(self.depth);
        let scores = Scores::new(&law);
        let begin = quantile(|z| pearson_two_sided(self.skewness, sign * z), level);
        let pull = self.pull(sign, begin);
        Tail::measure(effort.seed, effort.replicates, |rng| {
            let (t, log_ratio) = self.draw(&[pull], rng);
            let evidence = judged(&law, &scores, &t);
            let there = evidence.statistic * sign > 0.0 && evidence.p.is_some_and(|p| !(p > level));
            if there { libm::exp(log_ratio) } else { 0.0 }
        })
    }

    /// All lags from 2, each chain with pulls in a direction of its own.
    fn further(&self, level: f64, effort: Effort) -> Tail {
        let law = law(self.depth);
        let scores = Scores::new(&law);
        let reach = quantile(|x| chi_square_sf(7.0, x), level).sqrt();
        let unit = scores.variance() / (4096.0 * 4096.0) * (self.draws as f64).sqrt();
        Tail::measure(effort.seed, effort.replicates, |rng| {
            let direction = Direction::draw(LAGS - 1, rng);
            let pulls: Vec<f64> = [0.0].into_iter().chain(direction.0.iter().map(|v| v * reach / unit)).collect();
            let (t, log_ratio) = self.draw(&pulls, rng);
            let (mut cells, mut index, mut tally) = (CellTally::new(&law), Vec::new(), LagTally::default());
            cells.observe(&law, &t, &mut index);
            tally.observe(&scores, &index);
            if lags(&scores, &tally, &cells).p.is_none_or(|p| p > level) {
                return 0.0;
            }
            let scale = reach / unit / (4096.0 * 4096.0);
            let products: Vec<f64> = tally.products[1..].iter().map(|&product| scale * product as f64).collect();
            libm::exp(direction.ln_share(&products) + log_ratio)
        })
    }

    /// The pull at which the mean of the statistic is where the tail begins, from few chains.
    pub(crate) fn pull(&self, sign: f64, begin: f64) -> f64 {
        let law = law(self.depth);
        let scores = Scores::new(&law);
        let mean = |pull: f64| {
            let mut rng = Key { seed: 99, subject: 1, block: 0 }.rng();
            let one = |_| judged(&law, &scores, &self.draw(&[sign * pull], &mut rng).0).statistic * sign;
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

    /// A chain in which the next score s' has density in proportion to exp(sum of pull s s') over the scores s before it, the
    /// nearest first, and the log of its likelihood ratio.
    pub(crate) fn draw(&self, pulls: &[f64], rng: &mut impl Rng) -> (Vec<f64>, f64) {
        let (atom, mut before, mut log_ratio) = (libm::exp(-self.depth), vec![0.0; pulls.len()], 0.0);
        let mut one = |_| {
            let lean: f64 = pulls.iter().zip(&before).map(|(pull, score)| pull * score).sum();
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
            before.rotate_right(1);
            before[0] = score;
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

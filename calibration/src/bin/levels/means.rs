//! Student's t and Hall's statistic: laws at the gates of skewness, through the test itself.

use crate::Effort;
use crate::table::Row;
use freepath_calibration::finite::Finite;
use freepath_calibration::multinomial::quantile;
use freepath_calibration::tail::Tail;
use freepath_results::Reason;
use freepath_statistics::hypothesis::{MeanClaim, mean};
use freepath_statistics::special::{normal_quantile, student_t_two_sided};

/// The statistic that a lean aims at.
#[derive(Clone, Copy, PartialEq)]
enum Aim {
    Student,
    Hall,
}

pub(crate) fn rows(effort: Effort) -> Vec<Row> {
    let mut rows = Vec::new();
    let gates = [(Aim::Student, 0.015), (Aim::Student, 0.0299), (Aim::Hall, 0.06), (Aim::Hall, 0.0999)];
    for (aim, gate) in gates {
        for n in [1u64 << 14, 1 << 16, 1 << 20] {
            let skewness = gate * (n as f64).sqrt();
            for (name, law) in laws(skewness) {
                let known = Some(law.skewness());
                rows.push(row(effort, aim, n, &name, &law, known));
            }
        }
    }
    let n = 1 << 14;
    for skewness in [0.5, 2.0] {
        rows.push(row(effort, Aim::Student, n, "gamma", &gamma(skewness), None));
    }
    for gate in [0.06, 0.15, 0.3] {
        let law = coin(gate * (n as f64).sqrt());
        rows.push(row(effort, Aim::Hall, n, "coin, formula unknown", &law, None));
    }
    for sigma in [1.0, 1.5] {
        rows.push(row(effort, Aim::Hall, n, "log-normal, formula unknown", &log_normal(sigma), None));
    }
    rows
}

/// Laws of this skewness, and their mirror images.
fn laws(skewness: f64) -> Vec<(String, Finite)> {
    let pair = |name: &str, law: Finite| {
        let mirrored = law.map(|x| -x);
        [(name.to_string(), law), (format!("{name}, mirrored"), mirrored)]
    };
    let mut all: Vec<_> = pair("coin", coin(skewness)).into();
    if skewness < 30.0 {
        all.extend(pair("gamma", gamma(skewness)));
    }
    all
}

/// 0 or 1 with this skewness: (1 - 2 p) / sqrt(p (1 - p)).
fn coin(skewness: f64) -> Finite {
    let p = quantile(|p| if p < 0.5 { (1.0 - 2.0 * p) / (p * (1.0 - p)).sqrt() } else { 0.0 }, skewness);
    Finite::coin(p)
}

/// The gamma law of this skewness, 2 / sqrt(shape), on a grid: x^(shape - 1) is integrated over each cell, e^-x is not.
fn gamma(skewness: f64) -> Finite {
    let shape = 4.0 / (skewness * skewness);
    let most = shape + 12.0 * shape.sqrt() + 40.0;
    let edge = |x: f64| most * libm::pow(x / 160.0, 3.0);
    let points: Vec<f64> = (0..160).map(|i| edge(f64::from(i) + 0.5)).collect();
    let power = |x: f64| libm::pow(edge(x), shape);
    let mut cell = (0..160).map(|i| power(f64::from(i) + 1.0) - power(f64::from(i)));
    Finite::new(points, |x| cell.next().unwrap_or(0.0) * libm::exp(-x))
}

/// exp(sigma Z) to Z = 6.
fn log_normal(sigma: f64) -> Finite {
    let z: Vec<f64> = (0..=110).map(|i| -5.0 + 0.1 * f64::from(i)).collect();
    Finite::new(z, |z| libm::exp(-0.5 * z * z)).map(|z| libm::exp(sigma * z))
}

fn row(effort: Effort, aim: Aim, n: u64, name: &str, law: &Finite, known: Option<f64>) -> Row {
    let skewness = law.skewness();
    let gate = skewness.abs() / (n as f64).sqrt();
    let test = if aim == Aim::Student { "mean (student_t)" } else { "mean (skewness_corrected)" };
    let setting = format!("{name}, n = {n}, skewness {skewness:.3} = {gate:.3} sqrt n");
    Row::new(test, setting, true, |level| {
        [-1.0, 1.0].map(|side| one_side(effort, (aim, side * score(aim, level, n)), n, law, known, level)).into()
    })
}

/// The score that begins the tail.
fn score(aim: Aim, level: f64, n: u64) -> f64 {
    match aim {
        Aim::Student => quantile(|t| student_t_two_sided(n as f64 - 1.0, t), level),
        Aim::Hall => normal_quantile(0.5 * level),
    }
}

fn one_side(
    effort: Effort,
    (aim, score): (Aim, f64),
    n: u64,
    law: &Finite,
    skewness: Option<f64>,
    level: f64,
) -> Tail {
    let (expected, _) = law.spread();
    let root = (n as f64).sqrt();
    let distance = match aim {
        Aim::Student => score / root,
        Aim::Hall => {
            let s = law.skewness();
            3.0 * (libm::cbrt(1.0 + s * (score / root - s / (6.0 * n as f64))) - 1.0) / s
        }
    };
    let claim = MeanClaim { expected, slack: 0.0, binary: false, range: None, variance: None, skewness };
    let leaning = law.leaning(n, distance);
    leaning.probability(effort.seed, effort.replicates, |counts| {
        let sums = law.sums(expected, counts);
        let (evidence, _) = mean("mean", &sums, &claim, Reason::Biased);
        let side = (sums.bias() < 0.0) == (score < 0.0);
        side && evidence.p.is_some_and(|p| !(p > level))
    })
}

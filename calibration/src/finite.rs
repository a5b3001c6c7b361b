//! Laws on finitely many points, and sums of their draws far out in the tail.

use crate::multinomial::counts;
use crate::tail::Tail;
use freepath_statistics::tally::PowerSums;

/// Points and their probabilities.
#[derive(Clone, Debug)]
pub struct Finite {
    /// Values.
    pub points: Vec<f64>,
    /// Probabilities; they sum to 1.
    pub mass: Vec<f64>,
}

/// A way to lean a law: mass in proportion to exp(a y + b y^2), y the standardised value.
#[derive(Clone, Copy, Debug)]
struct Lean {
    a: f64,
    b: f64,
}

/// Counts of n leaning draws, and their likelihood ratio.
pub struct Leaning {
    n: u64,
    mass: Vec<f64>,
    /// ln(p / q) at each point.
    log_ratio: Vec<f64>,
}

impl Finite {
    /// Mass in proportion to `weight` at each of `points`.
    #[must_use]
    pub fn new(points: Vec<f64>, mut weight: impl FnMut(f64) -> f64) -> Self {
        let weights: Vec<f64> = points.iter().map(|&x| weight(x)).collect();
        let total: f64 = weights.iter().sum();
        Self { points, mass: weights.iter().map(|w| w / total).collect() }
    }

    /// 1 with probability `p`, else 0.
    #[must_use]
    pub fn coin(p: f64) -> Self {
        Self { points: vec![0.0, 1.0], mass: vec![1.0 - p, p] }
    }

    /// `f` of its values.
    #[must_use]
    pub fn map(&self, f: impl Fn(f64) -> f64) -> Self {
        Self { points: self.points.iter().map(|&x| f(x)).collect(), mass: self.mass.clone() }
    }

    /// E X^k.
    #[must_use]
    pub fn moment(&self, k: i32) -> f64 {
        self.points.iter().zip(&self.mass).map(|(x, p)| p * libm::pow(*x, f64::from(k))).sum()
    }

    /// Mean and standard deviation.
    #[must_use]
    pub fn spread(&self) -> (f64, f64) {
        spread(&self.points, &self.mass)
    }

    /// Skewness.
    #[must_use]
    pub fn skewness(&self) -> f64 {
        let (mean, sd) = self.spread();
        self.map(|x| (x - mean) / sd).moment(3)
    }

    /// The lean that is nearest to the law among those whose mean is off by `distance` of their own standard deviations: where
    /// a self-normalised mean first reaches it (Shao 1997).
    #[must_use]
    pub fn leaning(&self, n: u64, distance: f64) -> Leaning {
        let (mean, sd) = self.spread();
        let y: Vec<f64> = self.points.iter().map(|x| (x - mean) / sd).collect();
        let of = |b: f64| {
            let a = self.reach(&y, b, distance);
            let q = self.lean(&y, Lean { a, b });
            (divergence(&q, &self.mass), q)
        };
        let (mut low, mut high) = (-1.0 - distance * distance, 0.5);
        for _ in 0..60 {
            let (left, right) = (low + 0.382 * (high - low), low + 0.618 * (high - low));
            if of(left).0 < of(right).0 { high = right } else { low = left }
        }
        self.with(n, of(0.5 * (low + high)).1)
    }

    /// The lean whose mean is off by `distance` standard deviations of the law itself.
    #[must_use]
    pub fn leaning_mean(&self, n: u64, distance: f64) -> Leaning {
        let (mean, sd) = self.spread();
        let y: Vec<f64> = self.points.iter().map(|x| (x - mean) / sd).collect();
        let (mut low, mut high) = (-50.0, 50.0);
        for _ in 0..80 {
            let a = 0.5 * (low + high);
            if spread(&y, &self.lean(&y, Lean { a, b: 0.0 })).0 < distance { low = a } else { high = a }
        }
        self.with(n, self.lean(&y, Lean { a: 0.5 * (low + high), b: 0.0 }))
    }

    fn with(&self, n: u64, mass: Vec<f64>) -> Leaning {
        let log_ratio = self.mass.iter().zip(&mass).map(|(p, q)| libm::log(p / q)).collect();
        Leaning { n, mass, log_ratio }
    }

    /// The power sums of draws with these counts.
    #[must_use]
    pub fn sums(&self, center: f64, counts: &[u64]) -> PowerSums {
        let mut all = PowerSums::new(center);
        for (&x, &n) in self.points.iter().zip(counts).filter(|(_, n)| **n > 0) {
            let mut one = PowerSums::of(center, &[x]);
            one.sums.iter_mut().for_each(|sum| *sum *= n as f64);
            one.absolute *= n as f64;
            (one.n, one.zeros, one.ones) = (n, one.zeros * n, one.ones * n);
            all.merge(&one);
        }
        all
    }

    /// The `a` at which the leaning mean is `distance` of its own standard deviations off.
    fn reach(&self, y: &[f64], b: f64, distance: f64) -> f64 {
        let off = |a: f64| {
            let (mean, sd) = spread(y, &self.lean(y, Lean { a, b }));
            mean - distance * sd
        };
        let (mut low, mut high) = (-50.0, 50.0);
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            if off(middle) < 0.0 { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }

    fn lean(&self, y: &[f64], Lean { a, b }: Lean) -> Vec<f64> {
        let log: Vec<f64> = y.iter().zip(&self.mass).map(|(y, p)| libm::log(*p) + a * y + b * y * y).collect();
        let most = log.iter().fold(f64::NEG_INFINITY, |m, &x| if x > m { x } else { m });
        let weights: Vec<f64> = log.iter().map(|x| libm::exp(x - most)).collect();
        let total: f64 = weights.iter().sum();
        weights.iter().map(|w| w / total).collect()
    }
}

impl Leaning {
    /// The probability under the law itself that `event` holds of the counts at its points.
    pub fn probability(&self, seed: u64, replicates: u64, event: impl Fn(&[u64]) -> bool + Sync) -> Tail {
        Tail::measure(seed, replicates, |rng| {
            let counts = counts(self.n, &self.mass, rng);
            if !event(&counts) {
                return 0.0;
            }
            let log: f64 =
                counts.iter().zip(&self.log_ratio).filter(|(n, _)| **n > 0).map(|(&n, r)| n as f64 * r).sum();
            libm::exp(log)
        })
    }
}

fn spread(points: &[f64], mass: &[f64]) -> (f64, f64) {
    let mean: f64 = points.iter().zip(mass).map(|(x, p)| p * x).sum();
    let variance: f64 = points.iter().zip(mass).map(|(x, p)| p * (x - mean) * (x - mean)).sum();
    (mean, variance.sqrt())
}

/// Kullback-Leibler divergence of q from p.
fn divergence(q: &[f64], p: &[f64]) -> f64 {
    q.iter().zip(p).filter(|(q, _)| **q > 0.0).map(|(q, p)| q * libm::log(q / p)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_statistics::special::binomial_sf;

    #[test]
    fn the_tail_of_a_coin_is_binomial() {
        let coin = Finite::coin(0.05);
        let (n, k) = (1000, 95);
        let distance = (0.095 - 0.05) / (0.095f64 * 0.905).sqrt();
        let tail = coin.leaning(n, distance).probability(1, 50_000, |counts| counts[1] >= k);
        let ((level, error), exact) = (tail.probability(), binomial_sf(n, 0.05, k));
        assert!((level - exact).abs() < 5.0 * error && error < 0.05 * exact, "{level} {error} {exact}");
    }

    #[test]
    fn sums_are_those_of_the_draws() {
        let law = Finite::new(vec![0.0, 0.5, 2.0], |_| 1.0);
        let sums = law.sums(0.25, &[1, 2, 3]);
        let drawn = PowerSums::of(0.25, &[0.0, 0.5, 0.5, 2.0, 2.0, 2.0]);
        assert_eq!((sums.n, sums.zeros, sums.ones), (drawn.n, drawn.zeros, drawn.ones));
        assert!(sums.sums.iter().zip(drawn.sums).all(|(a, b)| (a - b).abs() < 1e-12));
    }
}

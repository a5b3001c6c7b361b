//! Pearson's chi-square of a multinomial count.

use crate::tail::Tail;
use freepath_statistics::special::chi_square_sf;
use rand::Rng;
use rand_distr::{Binomial, Distribution, Gamma};

/// Counts of `n` draws in cells of these probabilities.
#[derive(Clone, Debug)]
pub struct Multinomial {
    /// Draws.
    pub n: u64,
    /// Probabilities; they sum to 1.
    pub mass: Vec<f64>,
}

impl Multinomial {
    /// Cells that expect so many draws.
    #[must_use]
    pub fn expecting(expected: &[f64]) -> Self {
        let total: f64 = expected.iter().sum();
        Self { n: total.round() as u64, mass: expected.iter().map(|e| e / total).collect() }
    }

    /// sum (O - E)^2 / E.
    #[must_use]
    pub fn statistic(&self, counts: &[u64]) -> f64 {
        let n = self.n as f64;
        let term = |(&o, p): (&u64, f64)| (o as f64 - n * p) * (o as f64 - n * p) / (n * p);
        counts.iter().zip(self.mass.iter().copied()).map(term).sum()
    }

    /// P(chi-square tail of the statistic <= `level`), by counts of which the statistic has its mean where the tail begins.
    ///
    /// # Panics
    /// If the cells are fewer than two.
    #[must_use]
    pub fn level(&self, level: f64, seed: u64, replicates: u64) -> Tail {
        let dof = (self.mass.len() - 1) as f64;
        let begin = quantile(|x| chi_square_sf(dof, x), level);
        let spread = self.spread(begin / dof);
        Tail::measure(seed, replicates, |rng| {
            let counts = spread.counts(rng);
            if self.statistic(&counts) >= begin { libm::exp(spread.log_ratio(&counts)) } else { 0.0 }
        })
    }

    /// Counts whose variance is `spread > 1` times as large.
    ///
    /// # Panics
    /// If a cell has no probability, or `spread` is not above 1.
    #[must_use]
    pub fn spread(&self, spread: f64) -> Spread<'_> {
        let total = (self.n as f64 - 1.0) / (spread - 1.0) - 1.0;
        let alpha: Vec<f64> = self.mass.iter().map(|p| total * p).collect();
        let gammas = alpha.iter().map(|&a| Gamma::new(a, 1.0).expect("a positive shape")).collect();
        Spread { of: self, total, alpha, gammas }
    }
}

/// Multinomial counts with probabilities that are themselves Dirichlet.
pub struct Spread<'a> {
    of: &'a Multinomial,
    total: f64,
    alpha: Vec<f64>,
    gammas: Vec<Gamma<f64>>,
}

impl Spread<'_> {
    /// One set of counts.
    pub fn counts(&self, rng: &mut impl Rng) -> Vec<u64> {
        let shares: Vec<f64> = self.gammas.iter().map(|gamma| gamma.sample(rng)).collect();
        counts(self.of.n, &shares, rng)
    }

    /// The logarithm of the chance of `counts` under the multinomial, over that under this law.
    #[must_use]
    pub fn log_ratio(&self, counts: &[u64]) -> f64 {
        let cell = |((&x, p), a): ((&u64, f64), f64)| {
            let x = x as f64;
            x * libm::log(p) + libm::lgamma(a) - libm::lgamma(x + a)
        };
        let cells = counts.iter().zip(self.of.mass.iter().copied()).zip(self.alpha.iter().copied());
        libm::lgamma(self.of.n as f64 + self.total) - libm::lgamma(self.total) + cells.map(cell).sum::<f64>()
    }
}

/// Multinomial counts of `n` draws with probabilities in proportion to `shares`, cell by cell.
pub fn counts(n: u64, shares: &[f64], rng: &mut impl Rng) -> Vec<u64> {
    let (mut left, mut rest) = (n, shares.iter().sum::<f64>());
    let mut one = |&share: &f64| {
        let p = share / rest;
        let p = if p < 1.0 { p } else { 1.0 };
        // what is next to impossible is left out: the sampler refuses it
        let count = if p > 1e-18 { Binomial::new(left, p).expect("a probability").sample(rng) } else { 0 };
        (left, rest) = (left - count, rest - share);
        count
    };
    let (_, first) = shares.split_last().expect("there are cells");
    let mut all: Vec<u64> = first.iter().map(&mut one).collect();
    all.push(left);
    all
}

/// The x > 0 at which the falling function `tail` reaches `level`.
pub fn quantile(tail: impl Fn(f64) -> f64, level: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    while tail(high) > level {
        (low, high) = (high, 2.0 * high);
    }
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if tail(middle) > level { low = middle } else { high = middle }
    }
    high
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_cells_give_the_binomial_law() {
        let two = Multinomial::expecting(&[400.0, 400.0]);
        let begin = quantile(|x| chi_square_sf(1.0, x), 1e-6);
        let least = (0..=800).find(|&k| two.statistic(&[400 + k, 400 - k]) >= begin).expect("the tail begins");
        let exact = 2.0 * freepath_statistics::special::binomial_sf(800, 0.5, 400 + least);
        let (level, error) = two.level(1e-6, 1, 100_000).probability();
        assert!((level - exact).abs() < 5.0 * error && error < 0.05 * exact, "{level} {error} {exact}");
    }

    #[test]
    fn plain_sampling_agrees() {
        let many = Multinomial::expecting(&[20.0; 8]);
        let begin = quantile(|x| chi_square_sf(7.0, x), 1e-2);
        let plain = Tail::measure(2, 200_000, |rng| {
            f64::from(u8::from(many.statistic(&counts(160, &[1.0; 8], rng)) >= begin))
        });
        let ((a, da), (b, db)) = (plain.probability(), many.level(1e-2, 3, 200_000).probability());
        assert!((a - b).abs() < 4.0 * (da * da + db * db).sqrt(), "{a} {da} {b} {db}");
    }
}

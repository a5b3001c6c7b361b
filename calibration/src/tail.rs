//! The probability of a rare event from weighted replicates.

use freepath_draws::Key;
use rand_xoshiro::Xoshiro256PlusPlus;
use rayon::prelude::*;

/// Replicates of a block: a generator each, so that results do not depend on threads.
const BLOCK: u64 = 256;

/// Sums over replicates of the likelihood ratio where the event happened.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tail {
    /// Replicates.
    pub count: u64,
    /// The sum of weights.
    pub sum: f64,
    /// The sum of squared weights.
    pub squares: f64,
}

impl Tail {
    /// `replicate` gives the likelihood ratio where the event happens, else 0.
    pub fn measure(seed: u64, replicates: u64, replicate: impl Fn(&mut Xoshiro256PlusPlus) -> f64 + Sync) -> Self {
        let block = |block: u64| {
            let mut rng = Key { seed, subject: 0, block }.rng();
            (0..BLOCK).fold(Self::default(), |tail, _| {
                let weight = replicate(&mut rng);
                tail.plus(Self { count: 1, sum: weight, squares: weight * weight })
            })
        };
        let blocks: Vec<Self> = (0..replicates.div_ceil(BLOCK)).into_par_iter().map(block).collect();
        blocks.into_iter().fold(Self::default(), Self::plus)
    }

    fn plus(self, other: Self) -> Self {
        Self { count: self.count + other.count, sum: self.sum + other.sum, squares: self.squares + other.squares }
    }

    /// The probability, and its standard error.
    #[must_use]
    pub fn probability(&self) -> (f64, f64) {
        let n = self.count as f64;
        let mean = self.sum / n;
        (mean, ((self.squares / n - mean * mean) / n).sqrt())
    }
}

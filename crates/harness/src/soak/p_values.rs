//! Many p-values in little room.

use freepath_statistics::larger;

/// Equal bins of [0, 1].
const BINS: usize = 4096;
/// So many of the smallest are kept as they are.
const LEAST: usize = 256;

/// Any number of p-values: a histogram, the smallest of them, and counts at or below the powers of ten.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PValues {
    /// Bin `k` holds those in (k, k + 1] / BINS, the first 0 as well.
    bins: Vec<u64>,
    /// The smallest, in no order; at most twice as many as are kept.
    least: Vec<f64>,
    /// At or below 10^-1, 10^-2, ..
    below: [u64; DECADES],
    /// Their number.
    pub(super) count: u64,
}

/// Levels 10^-1 to 10^-7.
pub(super) const DECADES: usize = 7;

/// 10^-(i + 1).
pub(super) const LEVELS: [f64; DECADES] = [0.1, 0.01, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7];

/// The distances of an empirical CDF from the uniform one, over the edges of the bins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Distances {
    /// Its largest excess over the uniform one.
    pub(super) over: f64,
    /// The largest excess of the uniform one over it.
    pub(super) under: f64,
}

impl PValues {
    pub(super) fn new() -> Self {
        Self { bins: vec![0; BINS], least: Vec::new(), below: [0; DECADES], count: 0 }
    }

    /// Takes in one p-value; NaN counts as 0.
    pub(super) fn observe(&mut self, p: f64) {
        let p = if p >= 0.0 { p } else { 0.0 };
        let bin = (p * BINS as f64).ceil() as usize;
        self.bins[if bin > BINS { BINS } else { bin }.saturating_sub(1)] += 1;
        for (count, level) in self.below.iter_mut().zip(LEVELS) {
            *count += u64::from(!(p > level));
        }
        self.count += 1;
        self.least.push(p);
        self.thin(2 * LEAST);
    }

    pub(super) fn merge(&mut self, other: &Self) {
        self.bins.iter_mut().zip(&other.bins).for_each(|(a, b)| *a += b);
        self.below.iter_mut().zip(&other.below).for_each(|(a, b)| *a += b);
        self.count += other.count;
        self.least.extend(&other.least);
        self.thin(2 * LEAST);
    }

    fn thin(&mut self, most: usize) {
        if self.least.len() > most {
            self.least = self.smallest();
        }
    }

    /// The smallest in ascending order.
    pub(super) fn smallest(&self) -> Vec<f64> {
        let mut least = self.least.clone();
        least.sort_unstable_by(f64::total_cmp);
        least.truncate(LEAST);
        least
    }

    /// The number at or below each of [`LEVELS`].
    pub(super) fn below(&self) -> [u64; DECADES] {
        self.below
    }

    /// The distances of their CDF from the uniform one.
    pub(super) fn distances(&self) -> Distances {
        let (mut sum, mut over, mut under) = (0, 0.0, 0.0);
        for (k, count) in self.bins.iter().enumerate() {
            sum += count;
            let gap = sum as f64 / self.count as f64 - (k + 1) as f64 / BINS as f64;
            (over, under) = (larger(over, gap), larger(under, -gap));
        }
        Distances { over, under }
    }

    /// Pairs of (uniform quantile, p-value of that rank), ascending: the smallest ones at ever larger ranks, then one for
    /// every 32nd of the bins' edges.
    pub(super) fn quantiles(&self) -> Vec<(f64, f64)> {
        let (n, smallest) = (self.count as f64, self.smallest());
        let mut pairs = Vec::new();
        let mut rank = 1;
        while rank <= smallest.len() {
            pairs.push(((rank as f64 - 0.5) / n, smallest[rank - 1]));
            rank += 1 + rank / 16;
        }
        let (exact, mut sum) = (pairs.last().map_or(0.0, |pair| pair.0), 0);
        for (k, count) in self.bins.iter().enumerate() {
            sum += count;
            let reached = (sum as f64 - 0.5) / n;
            if (k + 1) % 32 == 0 && reached > exact {
                pairs.push((reached, (k + 1) as f64 / BINS as f64));
            }
        }
        pairs
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_results::MOST_POINTS;

    fn even(n: u32) -> PValues {
        let mut all = PValues::new();
        (0..n).for_each(|i| all.observe((f64::from(i) + 0.5) / f64::from(n)));
        all
    }

    #[test]
    fn an_even_grid_is_uniform_and_its_half_is_not() {
        let Distances { over, under } = even(10_000).distances();
        assert!(over < 3e-4 && under < 3e-4, "{over} {under}");
        let mut half = PValues::new();
        (0..1000).for_each(|i| half.observe(f64::from(i) / 2000.0));
        assert!(half.distances().over > 0.49);
    }

    #[test]
    fn merging_is_observing_all() {
        let (mut parts, mut whole) = ([PValues::new(), PValues::new()], PValues::new());
        for i in 0..3000 {
            let p = f64::from(i * 7919 % 3001) / 3001.0;
            parts[i as usize % 2].observe(p);
            whole.observe(p);
        }
        let [mut a, b] = parts;
        a.merge(&b);
        assert_eq!((a.smallest(), a.below(), a.distances()), (whole.smallest(), whole.below(), whole.distances()));
    }

    #[test]
    fn nan_counts_as_zero_and_quantiles_are_few() {
        let mut all = even(100_000);
        all.observe(f64::NAN);
        assert!(all.smallest()[0] <= 0.0 && all.below()[DECADES - 1] == 1);
        let pairs = all.quantiles();
        assert!(pairs.len() <= MOST_POINTS && pairs.len() > 100);
        assert!(pairs.windows(2).all(|w| w[0].0 < w[1].0 && w[0].1 <= w[1].1));
    }
}

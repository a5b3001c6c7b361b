use super::smallest::Smallest;
use crate::special::pareto_shape;

/// Most values kept.
const MOST: usize = 4096;

/// Fewest values above the threshold that a shape is fitted to.
const FEWEST: usize = 50;

/// Fewest values above the threshold for a bound of the shape.
const FEWEST_OF_A_LOOK: usize = 64;

/// Draws that share the largest |x| where it is an atom.
const ATOM: usize = 16;

/// The largest |x| of a stream, kept exactly, for the shape of its tail.
#[derive(Clone, Debug, PartialEq)]
pub struct Tail {
    largest: Smallest,
}

impl Default for Tail {
    fn default() -> Self {
        Self { largest: Smallest::new(MOST + 1) }
    }
}

impl Tail {
    /// Takes in a column; NaN and infinity are passed over.
    pub fn observe(&mut self, column: &[f64]) {
        let key = |x: f64| if x.is_finite() { -x.abs() } else { f64::NAN };
        self.largest.observe(column, key);
    }

    /// Takes in what another worker holds.
    pub fn merge(&mut self, other: &Self) {
        self.largest.merge(&other.largest);
    }

    /// The Pareto shape k of the tail of `n` draws: moments of order 1 / k and above do not exist. None if fewer than 50 values
    /// differ from the threshold.
    ///
    /// ```text
    /// M = min(3 sqrt n, n / 5, 4096) largest |x|, less the next one;   and M / 2, M / 4, ..: the least shape of all
    /// ```
    ///
    /// Vehtari, Simpson, Gelman, Yao and Gabry (2024) take M alone; the fit is [`pareto_shape`]. Weights come in clusters,
    /// one for each number of collisions: a threshold within one sees the next as a tail, a higher threshold does not. A
    /// Pareto law has its shape above every threshold.
    #[must_use]
    pub fn shape(&self, n: u64) -> Option<f64> {
        let largest = self.largest();
        let halves = std::iter::successors(Some(wanted(n)), |m| Some(m / 2)).take_while(|m| *m >= FEWEST);
        let of = |m| excess(&largest, m, FEWEST).map(|excess| pareto_shape(&excess));
        halves.filter_map(of).reduce(least)
    }

    /// The upper bound of the Pareto shape of the tail of `n` draws: a tail of shape 1/2 has one below 1/2 with probability 5 % at
    /// most. None if fewer than 64 values differ from the threshold, or if 16 draws or more share the largest |x|: then it is an atom.
    ///
    /// ```text
    /// min over M and M / 4 of k + 1.96 (1 + max(k, 0)) / sqrt(m),   m values above the threshold
    /// ```
    ///
    /// The variance of k is that of the likelihood (Smith 1987). Two looks at 2.5 % each, the second for weights that come in clusters.
    #[must_use]
    pub fn shape_bound(&self, n: u64) -> Option<f64> {
        let (largest, m) = (self.largest(), wanted(n));
        if largest.len() >= ATOM && largest[ATOM - 1] >= largest[0] {
            return None;
        }
        let of =
            |m| excess(&largest, m, FEWEST_OF_A_LOOK).map(|excess| upper(pareto_shape(&excess), excess.len()));
        [m, m / 4].into_iter().filter_map(of).reduce(least)
    }

    /// The largest |x|, decreasing.
    fn largest(&self) -> Vec<f64> {
        self.largest.sorted().into_iter().map(f64::abs).collect()
    }
}

/// The values of `n` draws that belong to the tail.
fn wanted(n: u64) -> usize {
    let n = n as f64;
    [3.0 * n.sqrt(), 0.2 * n].map(|m| m as usize).into_iter().fold(MOST, usize::min)
}

/// The lesser of two; NaN stays.
fn least(a: f64, b: f64) -> f64 {
    if a < b || a.is_nan() { a } else { b }
}

/// The bound that a shape fitted to `m` values stays below, but with probability 2.5 %.
fn upper(shape: f64, m: usize) -> f64 {
    let scale = if shape < 0.0 { 1.0 } else { 1.0 + shape };
    shape + 1.96 * scale / (m as f64).sqrt()
}

/// What the first `m` of the decreasing values have above the next one, increasing, unless too few are above it.
fn excess(largest: &[f64], m: usize, fewest: usize) -> Option<Vec<f64>> {
    let threshold = largest.get(m)?;
    let mut excess: Vec<f64> = largest[..m].iter().map(|x| x - threshold).filter(|x| *x > 0.0).collect();
    excess.reverse();
    (excess.len() >= fewest).then_some(excess)
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_draws::Key;
    use freepath_draws::random::uniform;

    /// Draws by inversion of their upper tail.
    fn shape(n: usize, of: impl Fn(f64) -> f64) -> Option<f64> {
        let mut rng = Key { seed: 7, subject: 1, block: 0 }.rng();
        let draws: Vec<f64> = (0..n).map(|_| of(1.0 - uniform(&mut rng))).collect();
        let mut tail = Tail::default();
        draws.chunks(1000).for_each(|part| tail.observe(part));
        tail.shape(n as u64)
    }

    #[test]
    fn the_shape_of_known_tails_is_found() {
        for k in [0.2, 0.5, 0.8, 1.2] {
            let found = shape(100_000, |u| libm::pow(u, -k)).unwrap_or(f64::NAN);
            assert!((found - k).abs() < 0.15, "{k}: {found}");
        }
        assert!(shape(100_000, |u| -libm::log(u)) < Some(0.15), "exponential");
        assert!(shape(100_000, |u| 1.0 - u) < Some(-0.5), "uniform");
    }

    /// Ever rarer clusters, ever farther out, but not for ever.
    #[test]
    fn clusters_of_weights_are_no_tail() {
        let weight = |u: f64| {
            if u < 1e-3 {
                10.0
            } else if u < 0.1 {
                3.0
            } else {
                1.0
            }
        };
        assert!(shape(100_000, |u| weight(u) + 0.1 * u) < Some(0.25));
        let narrow = |u: f64| if u < 2e-3 { 10.0 } else { 1.0 };
        assert!(shape(1_000_000, |u| narrow(u) + 1e-3 * (1e4 * u).fract()) < Some(0.25));
    }

    #[test]
    fn the_sign_does_not_matter_and_ties_are_no_tail() {
        let one = shape(50_000, |u| libm::pow(u, -0.7));
        assert_eq!(one, shape(50_000, |u| -libm::pow(u, -0.7)));
        assert_eq!(shape(50_000, |u| if u < 0.3 { 5.0 } else { 1.0 }), None);
        assert_eq!(shape(3, |u| u), None);
    }

    /// The share of runs of 16,384 draws in which two looks leave no doubt of a variance.
    fn passes(of: impl Fn(f64) -> f64) -> f64 {
        let run = |block| {
            let mut rng = Key { seed: 12, subject: 1, block }.rng();
            let draws: Vec<f64> = (0..16_384).map(|_| of(1.0 - uniform(&mut rng))).collect();
            let mut tail = Tail::default();
            tail.observe(&draws);
            tail.shape_bound(16_384) < Some(0.5)
        };
        (0..300).filter(|&block| run(block)).count() as f64 / 300.0
    }

    #[test]
    fn a_mean_without_variance_passes_two_looks_in_one_of_twenty_runs() {
        for (k, due) in [(0.3, 0.85), (0.4, 0.38), (0.45, 0.17), (0.5, 0.065), (0.6, 0.02)] {
            let share = passes(|u| libm::pow(u, -k));
            assert!((share - due).abs() < 0.09, "{k}: {share}, {due} simulated"); // three standard errors of both
        }
        assert!(passes(|u| -libm::log(u)) > 0.99 && passes(|u| u) > 0.99);
    }

    #[test]
    fn an_atom_at_the_top_is_no_tail() {
        let bound = |of: fn(u32) -> f64| {
            let mut tail = Tail::default();
            tail.observe(&(0..20_000).map(of).collect::<Vec<f64>>());
            tail.shape_bound(20_000)
        };
        assert_eq!(bound(|i| if i % 1000 == 0 { 100.0 } else { 1.0 + f64::from(i % 7919) / 7919.0 }), None);
        assert!(bound(|i| f64::from(i % 7919)).is_some());
    }
}

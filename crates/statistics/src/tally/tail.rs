use super::smallest::Smallest;
use crate::special::pareto_shape;

/// Most values kept.
const MOST: usize = 4096;

/// Fewest values above the threshold that a shape is fitted to.
const FEWEST: usize = 50;

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
        let n = n as f64;
        let wanted = [3.0 * n.sqrt(), 0.2 * n].map(|m| m as usize).into_iter().fold(MOST, usize::min);
        let largest: Vec<f64> = self.largest.sorted().into_iter().map(f64::abs).collect();
        let halves = std::iter::successors(Some(wanted), |m| Some(m / 2)).take_while(|m| *m >= FEWEST);
        let least = |a: f64, b: f64| if a < b || a.is_nan() { a } else { b };
        halves.filter_map(|m| above(&largest, m)).reduce(least)
    }
}

/// The shape of the first `m` of the decreasing values above the next one, unless too few are.
fn above(largest: &[f64], m: usize) -> Option<f64> {
    let threshold = largest.get(m)?;
    let mut excess: Vec<f64> = largest[..m].iter().map(|x| x - threshold).filter(|x| *x > 0.0).collect();
    excess.reverse();
    if excess.len() < FEWEST { None } else { Some(pareto_shape(&excess)) }
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
}

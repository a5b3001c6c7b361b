//! Tails of a sum of squares, by replicates that lean towards one direction each.

use rand::Rng;
use rand_distr::{Distribution, StandardNormal};

/// A direction, uniform on the sphere.
#[derive(Clone, Debug)]
pub struct Direction(pub Vec<f64>);

impl Direction {
    /// One of so many dimensions.
    pub fn draw(dimensions: usize, rng: &mut impl Rng) -> Self {
        let normal: Vec<f64> = (0..dimensions).map(|_| StandardNormal.sample(rng)).collect();
        let norm = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
        Self(normal.iter().map(|x| x / norm).collect())
    }

    /// The logarithm of what a vector x counts for a replicate that leans along this direction v: exp(v x) over its mean over
    /// all directions, so that over all of them a vector counts 1. It takes away what exp(-v x) in a likelihood ratio makes
    /// uneven.
    ///
    /// ```text
    /// E exp(v x) = 0F1(; d / 2; |x|^2 / 4)
    /// ```
    #[must_use]
    pub fn ln_share(&self, x: &[f64]) -> f64 {
        let along: f64 = x.iter().zip(&self.0).map(|(a, b)| a * b).sum();
        let quarter = 0.25 * x.iter().map(|x| x * x).sum::<f64>();
        let (mut term, mut sum) = (1.0, 1.0);
        for k in 0..10_000 {
            let k = f64::from(k);
            term *= quarter / ((k + 1.0) * (0.5 * self.0.len() as f64 + k));
            sum += term;
            if term < 1e-17 * sum {
                break;
            }
        }
        along - libm::log(sum)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_have_the_mean_one() {
        let mut rng = freepath_draws::Key::default().rng();
        for dimensions in [3, 7, 16] {
            let mut x = vec![0.3; dimensions];
            x[0] = -4.0;
            let n = 100_000;
            let sum: f64 = (0..n).map(|_| libm::exp(Direction::draw(dimensions, &mut rng).ln_share(&x))).sum();
            assert!((sum / f64::from(n) - 1.0).abs() < 0.05, "{dimensions} {}", sum / f64::from(n));
        }
    }
}

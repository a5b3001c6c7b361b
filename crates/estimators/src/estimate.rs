//! Estimators of a number: whatever has a mean that is known.

use freepath_draws::{Draws, PathColumns, Streams};

mod power;

/// Draws estimates of a number. A closure `Fn(&mut dyn Rng) -> f64` is an estimator, too.
pub trait Estimator: Send + Sync {
    /// One estimate.
    fn estimate(&self, rng: &mut dyn rand::Rng) -> f64;

    /// One estimate for each row of `out`. Provided: a loop over [`Estimator::estimate`].
    fn estimate_block(&self, streams: &Streams, out: &mut Draws) {
        let (mut rng, mut columns) = (streams.rng(), PathColumns::of(out));
        for row in 0..columns.rows() {
            let estimate = self.estimate(&mut rng);
            columns.put(row, f64::INFINITY, estimate, 0);
        }
    }
}

impl<F: Fn(&mut dyn rand::Rng) -> f64 + Send + Sync> Estimator for F {
    fn estimate(&self, rng: &mut dyn rand::Rng) -> f64 {
        self(rng)
    }
}

crate::list! {
    /// Every estimator of a number that a case can name.
    pub enum AnyEstimator: dyn Estimator {
        power::Power,
    }
}

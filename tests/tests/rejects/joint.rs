//! Draws that are right one by one, and wrong together.

use crate::path::{MU, in_part, path, right};
use freepath_draws::random::{exponential, uniform};
use freepath_draws::{Draws, PathColumns, Streams};
use freepath_estimators::{AuxiliaryPath, Extinction, FreePath, FreePathSampler};
use rand::Rng;
use std::sync::Mutex;

/// Each uniform serves twice: as it is, and changed by `fold` so many draws later.
pub(crate) struct Twice {
    pub(crate) lag: usize,
    pub(crate) fold: fn(f64) -> f64,
}

impl FreePathSampler for Twice {
    fn sample(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
        in_part(medium, rng)
    }
    fn sample_block(&self, _medium: &dyn Extinction, streams: &Streams, out: &mut Draws) {
        let (mut rng, mut kept) = (streams.rng(), vec![0.0; self.lag]);
        let mut columns = PathColumns::of(out);
        for row in 0..columns.rows() {
            let (round, place) = (row / self.lag, row % self.lag);
            let u = if round.is_multiple_of(2) { uniform(&mut rng) } else { (self.fold)(kept[place]) };
            kept[place] = u;
            let path = path(-libm::log1p(-u) / MU);
            columns.put(row, path.t, 1.0, 0);
        }
    }
}

/// Reuses the uniform of a flight when the next one is in another medium: alone in one medium nothing is wrong.
#[derive(Default)]
pub(crate) struct Resumed {
    /// The last length and, of an escape, its optical distance.
    pub(crate) last: Mutex<(f64, Option<f64>)>,
}

impl FreePathSampler for Resumed {
    fn sample(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
        let mut last = self.last.lock().expect("no draw panics");
        let kept = last.1.filter(|_| last.0.to_bits() != medium.length().to_bits());
        let depth = kept.unwrap_or_else(|| exponential(rng));
        let t = depth / medium.mu(0.0);
        *last = (medium.length(), (t >= medium.length()).then_some(depth));
        FreePath::at(if t < medium.length() { t } else { f64::INFINITY })
    }
    fn sample_block(&self, _medium: &dyn Extinction, streams: &Streams, out: &mut Draws) {
        let (mut rng, mut columns) = (streams.rng(), PathColumns::of(out));
        for row in 0..columns.rows() {
            columns.put(row, path(right(&mut rng)).t, 1.0, 0);
        }
    }
}

/// One draw in each of equal strata of a block, in random order.
pub(crate) struct Stratified;

impl FreePathSampler for Stratified {
    fn sample(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
        in_part(medium, rng)
    }
    fn sample_block(&self, _medium: &dyn Extinction, streams: &Streams, out: &mut Draws) {
        let (mut rng, mut columns) = (streams.rng(), PathColumns::of(out));
        let rows = columns.rows();
        let mut strata: Vec<usize> = (0..rows).collect();
        for row in (1..rows).rev() {
            strata.swap(row, (uniform(&mut rng) * (row + 1) as f64) as usize);
        }
        for (row, stratum) in strata.into_iter().enumerate() {
            let u = (stratum as f64 + uniform(&mut rng)) / rows as f64;
            columns.put(row, path(-libm::log1p(-u) / MU).t, 1.0, 0);
        }
    }
}

/// Gives an auxiliary number with each draw.
pub(crate) struct WithAuxiliary(pub(crate) fn(f64, f64) -> f64);

impl FreePathSampler for WithAuxiliary {
    fn sample(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
        in_part(medium, rng)
    }
    fn has_auxiliary(&self) -> bool {
        true
    }
    fn sample_with_auxiliary(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> AuxiliaryPath {
        let path = self.sample(medium, rng);
        AuxiliaryPath { path, auxiliary: (self.0)(path.t, uniform(rng)) }
    }
}

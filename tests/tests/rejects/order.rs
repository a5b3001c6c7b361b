//! Draws that are right one by one, and depend on others that are far away, or on where in the run they stand.

use crate::joint::Twice;
use crate::path::{MU, escape, in_part, of_path, path};
use freepath_draws::random::uniform;
use freepath_draws::{Draws, PathColumns, Streams};
use freepath_estimators::{Extinction, FreePath, FreePathSampler};
use freepath_results::Reason;
use freepath_tests::Judgement;
use rand::Rng;

/// Inverts the uniforms of a block after they were changed.
struct Changed(fn(&mut [f64]));

impl FreePathSampler for Changed {
    fn sample(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
        in_part(medium, rng)
    }
    fn sample_block(&self, _medium: &dyn Extinction, streams: &Streams, out: &mut Draws) {
        let (mut rng, mut columns) = (streams.rng(), PathColumns::of(out));
        let mut uniforms: Vec<f64> = (0..columns.rows()).map(|_| uniform(&mut rng)).collect();
        (self.0)(&mut uniforms);
        for (row, u) in uniforms.into_iter().enumerate() {
            columns.put(row, path(-libm::log1p(-u) / MU).t, 1.0, 0);
        }
    }
}

/// A batch that is handed out again and again.
fn copied(uniforms: &mut [f64]) {
    (1024..uniforms.len()).for_each(|row| uniforms[row] = uniforms[row - 1024]);
}

/// The same, where one draw in a hundred escapes: more are not rare.
fn rare(uniforms: &mut [f64]) {
    uniforms.iter_mut().for_each(|u| *u *= (1.0 - escape()) / 0.99);
    copied(uniforms);
}

/// The second half mirrors the first.
fn mirrored(uniforms: &mut [f64]) {
    let half = uniforms.len() / 2;
    (half..2 * half).for_each(|row| uniforms[row] = 1.0 - uniforms[row - half]);
}

/// The uniform of a distance whose extinction is `factor` times as large.
fn scaled(u: f64, factor: f64) -> f64 {
    -libm::expm1(libm::log1p(-u) / factor)
}

fn drifting(uniforms: &mut [f64]) {
    let saw = |row: usize| 1.0 + 0.2 * ((row % 2048) as f64 / 1024.0 - 1.0);
    uniforms.iter_mut().enumerate().for_each(|(row, u)| *u = scaled(*u, saw(row)));
}

fn stepping(uniforms: &mut [f64]) {
    let step = |row: usize| if (row / 1000).is_multiple_of(2) { 1.06 } else { 0.94 };
    uniforms.iter_mut().enumerate().for_each(|(row, u)| *u = scaled(*u, step(row)));
}

/// Every third number is the sum of the two before.
fn summed(uniforms: &mut [f64]) {
    (2..uniforms.len()).step_by(3).for_each(|row| uniforms[row] = (uniforms[row - 1] + uniforms[row - 2]) % 1.0);
}

fn stale(uniforms: &mut [f64]) {
    uniforms[..512].iter_mut().for_each(|u| *u = scaled(*u, 0.5));
}

/// None of the first escapes.
fn cold(uniforms: &mut [f64]) {
    uniforms[..512].iter_mut().for_each(|u| *u *= 1.0 - escape());
}

pub(crate) fn order() -> Vec<(&'static str, Reason, Judgement)> {
    let of = |name, change: fn(&mut [f64])| (name, Reason::Dependent, of_path(&Changed(change), 200_000));
    vec![
        of("order", mirrored),
        of("rare_lags", rare),
        of("period", drifting),
        ("pairs_far", Reason::Dependent, of_path(&Twice { lag: 2, fold: |u| (1.0 - 2.0 * u).abs() }, 200_000)),
        of("triples", summed),
        of("batches", stepping),
        of("along", stale),
        of("along_escapes", cold),
    ]
}

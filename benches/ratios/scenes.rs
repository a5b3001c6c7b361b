//! The media of the table, each as the engine and as a hand-written loop see it.

use crate::scalar;
use freepath_estimators::Extinction;
use freepath_estimators::medium::voxel_grid::{Filter, Grid, GridRay, Rescale};
use freepath_estimators::medium::{Gaussian, Sinusoid, Volume};
use std::sync::Arc;

type Fallible<T> = Result<T, Box<dyn std::error::Error>>;

const VOXELS: usize = 128;
const ORIGIN: [f64; 3] = [0.02, 0.10, 0.05];
const TOWARDS: [f64; 3] = [0.96, 0.80, 0.80];

pub(crate) fn gaussian() -> Fallible<Gaussian> {
    Ok(Gaussian::new(2.0, 5.0, 1.0, 10.0, 0.05)?)
}

pub(crate) fn sinusoid() -> Fallible<Sinusoid> {
    Ok(Sinusoid::new(1.0, 0.9, 1.0, 5.0, 0.0)?)
}

/// A smooth field of 128^3 voxels in the unit cube, and one oblique ray through it.
pub(crate) fn voxels() -> Fallible<(GridRay, scalar::Voxels)> {
    let centre = |i: usize| (i as f64 + 0.5) / VOXELS as f64;
    let wave = |waves: f64, i: usize| freepath_draws::math::sin2pi(waves * centre(i));
    let value = |i: usize| {
        let [x, y, z] = [i % VOXELS, i / VOXELS % VOXELS, i / (VOXELS * VOXELS)];
        let s = 0.5 + 0.5 * wave(3.0, x) * wave(2.0, y) * wave(1.0, z);
        10.0 * s * s
    };
    let values = (0..VOXELS * VOXELS * VOXELS).map(value).collect();
    let volume = Arc::new(Volume { shape: [VOXELS; 3], values, bounds: None });
    let bounds = [[0.0; 3], [1.0; 3]];
    let grid = Grid::new(volume.clone(), Filter::Trilinear, bounds, Rescale::default())?;
    let ray = grid.ray(ORIGIN, TOWARDS)?;
    let norm = TOWARDS.iter().map(|x| x * x).sum::<f64>().sqrt();
    let plain = scalar::Voxels {
        volume,
        origin: ORIGIN,
        direction: TOWARDS.map(|x| x / norm),
        length: ray.length(),
        mu_bar: ray.majorants().mu_bar()[0],
    };
    Ok((ray, plain))
}

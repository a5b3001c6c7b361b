//! Walks as an engineer writes them: generic loops, xoshiro256++, the logarithm, exponential and sine of the platform.

#![expect(clippy::disallowed_methods, reason = "the loops to compare with use what the platform offers")]

use freepath_estimators::medium::Volume;
use rand::RngExt;
use rand_xoshiro::Xoshiro256PlusPlus;
use std::f64::consts::PI;
use std::sync::Arc;

/// A medium as it would be passed to a template.
pub(crate) trait Plain {
    fn length(&self) -> f64;
    fn mu_bar(&self) -> f64;
    fn mu(&self, t: f64) -> f64;
}

pub(crate) struct Gaussian;

impl Plain for Gaussian {
    fn length(&self) -> f64 {
        10.0
    }
    fn mu_bar(&self) -> f64 {
        2.05
    }
    fn mu(&self, t: f64) -> f64 {
        0.05 + 2.0 * (-0.5 * (t - 5.0) * (t - 5.0)).exp()
    }
}

pub(crate) struct Sinusoid;

impl Plain for Sinusoid {
    fn length(&self) -> f64 {
        5.0
    }
    fn mu_bar(&self) -> f64 {
        1.9
    }
    fn mu(&self, t: f64) -> f64 {
        1.0 + 0.9 * (2.0 * PI * t).sin()
    }
}

/// Trilinear interpolation in a unit cube.
pub(crate) struct Voxels {
    pub(crate) volume: Arc<Volume>,
    pub(crate) origin: [f64; 3],
    pub(crate) direction: [f64; 3],
    pub(crate) length: f64,
    pub(crate) mu_bar: f64,
}

impl Plain for Voxels {
    fn length(&self) -> f64 {
        self.length
    }
    fn mu_bar(&self) -> f64 {
        self.mu_bar
    }
    fn mu(&self, t: f64) -> f64 {
        let [nx, ny, nz] = self.volume.shape;
        let (i, x) = self.cell(0, nx, t);
        let (j, y) = self.cell(1, ny, t);
        let (k, z) = self.cell(2, nz, t);
        let at = |j: usize, k: usize| {
            let row = (k * ny + j) * nx + i;
            lerp(self.volume.values[row], self.volume.values[row + 1], x)
        };
        lerp(lerp(at(j, k), at(j + 1, k), y), lerp(at(j, k + 1), at(j + 1, k + 1), y), z)
    }
}

impl Voxels {
    /// The cell along one axis, and the place in it.
    #[inline]
    fn cell(&self, axis: usize, n: usize, t: f64) -> (usize, f64) {
        let position = (self.origin[axis] + t * self.direction[axis]) * n as f64 - 0.5;
        let position = position.clamp(0.0, (n - 1) as f64);
        let cell = (position as usize).min(n - 2);
        (cell, position - cell as f64)
    }
}

#[inline]
fn lerp(a: f64, b: f64, s: f64) -> f64 {
    a + (b - a) * s
}

#[inline]
fn exponential(rng: &mut Xoshiro256PlusPlus) -> f64 {
    -(1.0 - rng.random::<f64>()).ln()
}

#[inline(never)]
pub(crate) fn delta<M: Plain>(medium: &M, rng: &mut Xoshiro256PlusPlus, out: &mut [f64]) {
    let (mu_bar, length) = (medium.mu_bar(), medium.length());
    for x in out {
        let mut t = 0.0;
        *x = loop {
            t += exponential(rng) / mu_bar;
            if t >= length {
                break f64::INFINITY;
            }
            if rng.random::<f64>() * mu_bar < medium.mu(t) {
                break t;
            }
        };
    }
}

#[inline(never)]
pub(crate) fn ratio<M: Plain>(medium: &M, rng: &mut Xoshiro256PlusPlus, out: &mut [f64]) {
    let (mu_bar, length) = (medium.mu_bar(), medium.length());
    for x in out {
        let (mut t, mut weight) = (0.0, 1.0);
        loop {
            t += exponential(rng) / mu_bar;
            if t >= length {
                break;
            }
            weight *= 1.0 - medium.mu(t) / mu_bar;
        }
        *x = weight;
    }
}

/// Three homogeneous channels as pbrt-v3 samples them: one channel for the distance, the mean density for the weights.
pub(crate) struct Chromatic {
    pub(crate) sigma_t: [f64; 3],
    pub(crate) sigma_s: [f64; 3],
    pub(crate) length: f64,
}

#[inline(never)]
pub(crate) fn chromatic(
    medium: &Chromatic,
    rng: &mut Xoshiro256PlusPlus,
    out: &mut [f64],
    weights: &mut [Vec<f64>; 3],
) {
    for (row, x) in out.iter_mut().enumerate() {
        let channel = ((rng.random::<f64>() * 3.0) as usize).min(2);
        let t = exponential(rng) / medium.sigma_t[channel];
        let scatters = t < medium.length;
        let reach = if scatters { t } else { medium.length };
        let survival = medium.sigma_t.map(|sigma| (-sigma * reach).exp());
        let density = |c: usize| {
            if scatters { medium.sigma_t[c] * survival[c] } else { survival[c] }
        };
        let pdf = (density(0) + density(1) + density(2)) / 3.0;
        for c in 0..3 {
            let event = if scatters { medium.sigma_s[c] } else { 1.0 };
            weights[c][row] = survival[c] * event / pdf;
        }
        *x = if scatters { t } else { f64::INFINITY };
    }
}

//! A medium, a free-path sampler and a transmittance estimator of one's own: what a renderer would bring.

use freepath::{Extinction, FreePath, FreePathSampler, Majorants, Medium, TransmittanceEstimator};
use rand::{Rng, RngExt};

/// A layer whose extinction falls like 1 / (1 + t / a)^2.
///
/// ```text
/// mu(t) = mu0 / (1 + t / a)^2,   tau(t) = mu0 t / (1 + t / a)
/// ```
#[derive(Clone, Debug)]
pub struct Layer {
    mu0: f64,
    a: f64,
    length: f64,
    majorants: Majorants,
}

impl Layer {
    /// Extinction `mu0` at the start, falling over `a`, on a ray of `length`.
    #[must_use]
    pub fn new(mu0: f64, a: f64, length: f64) -> Self {
        Self { mu0, a, length, majorants: Majorants::constant(mu0, length) }
    }
}

impl Extinction for Layer {
    fn length(&self) -> f64 {
        self.length
    }
    fn mu(&self, t: f64) -> f64 {
        let x = 1.0 + t / self.a;
        self.mu0 / (x * x)
    }
    fn majorants(&self) -> &Majorants {
        &self.majorants
    }
}

impl Medium for Layer {
    fn tau(&self, t: f64) -> f64 {
        self.mu0 * t / (1.0 + t / self.a)
    }
    fn extrema(&self, a: f64, b: f64) -> (f64, f64) {
        (self.mu(b), self.mu(a))
    }
}

/// Delta tracking as one writes it the first time.
#[derive(Clone, Copy, Debug)]
pub struct MyTracker;

impl FreePathSampler for MyTracker {
    fn sample(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
        let mu_bar = medium.majorants().mu_bar()[0];
        let mut t = 0.0;
        loop {
            t -= libm::log(1.0 - rng.random::<f64>()) / mu_bar;
            if t >= medium.length() {
                return FreePath::at(f64::INFINITY);
            }
            if rng.random::<f64>() * mu_bar < medium.mu(t) {
                return FreePath::at(t);
            }
        }
    }
}

/// Ratio tracking as one writes it the first time.
#[derive(Clone, Copy, Debug)]
pub struct MyRatio;

impl TransmittanceEstimator for MyRatio {
    fn estimate(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> f64 {
        let mu_bar = medium.majorants().mu_bar()[0];
        let (mut t, mut weight) = (0.0, 1.0);
        loop {
            t -= libm::log(1.0 - rng.random::<f64>()) / mu_bar;
            if t >= medium.length() {
                return weight;
            }
            weight *= 1.0 - medium.mu(t) / mu_bar;
        }
    }
}

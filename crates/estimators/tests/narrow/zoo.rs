//! 200 bumps, and their integrals in closed form.

use freepath_estimators::medium::Gaussian;
use freepath_estimators::transmittance::AnyTransmittance;
use freepath_estimators::{Extinction, Majorants, Medium};
use std::f64::consts::{FRAC_PI_2, SQRT_2};

pub(crate) const LENGTH: f64 = 2.0;
pub(crate) const BASE: f64 = 0.5;
pub(crate) const PEAK: f64 = 4.0;

/// A bump of height 4 over 0.5.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bump {
    pub(crate) center: f64,
    pub(crate) width: f64,
}

/// Widths from 1e-4 to 0.1, each at 25 places along the ray that no power of two divides.
pub(crate) fn bumps() -> Vec<Bump> {
    let widths = [1e-4, 3e-4, 1e-3, 3e-3, 0.01, 0.02, 0.05, 0.1];
    let place = |i: u32| LENGTH * (f64::from(i) + 0.317) / 25.1;
    widths.into_iter().flat_map(|width| (0..25).map(move |i| Bump { center: place(i), width })).collect()
}

impl Bump {
    pub(crate) fn medium(self) -> Gaussian {
        Gaussian::new(PEAK, self.center, self.width, LENGTH, BASE).expect("a medium")
    }

    /// int_a^b g^power, g the bump of height 1.
    pub(crate) fn area(self, power: u32, a: f64, b: f64) -> f64 {
        if power == 0 {
            return b - a;
        }
        let root = f64::from(power).sqrt();
        let side = |t: f64| libm::erf(root * (t - self.center) / (self.width * SQRT_2));
        self.width / root * FRAC_PI_2.sqrt() * (side(b) - side(a))
    }
}

/// A bump that does not tell where it is narrow: its tau is exact if `TAU`, and otherwise the one that is provided, from mu.
pub(crate) struct Hidden<const TAU: bool>(pub(crate) Gaussian);

impl<const TAU: bool> Extinction for Hidden<TAU> {
    fn length(&self) -> f64 {
        LENGTH
    }
    fn mu(&self, t: f64) -> f64 {
        self.0.mu(t)
    }
    fn majorants(&self) -> &Majorants {
        self.0.majorants()
    }
}

impl Medium for Hidden<false> {
    fn extrema(&self, a: f64, b: f64) -> (f64, f64) {
        self.0.extrema(a, b)
    }
}

impl Medium for Hidden<true> {
    fn tau(&self, t: f64) -> f64 {
        self.0.tau(t)
    }
    fn tau_error(&self) -> f64 {
        0.0
    }
    fn extrema(&self, a: f64, b: f64) -> (f64, f64) {
        self.0.extrema(a, b)
    }
}

pub(crate) fn estimator(json: &str) -> AnyTransmittance {
    serde_json::from_str(json).expect("an estimator")
}

/// Within `error` of `due`, relative to it.
pub(crate) fn close(found: f64, due: f64, error: f64, what: &dyn std::fmt::Debug) {
    assert!((found / due - 1.0).abs() <= error, "{what:?}: {found} for {due}");
}

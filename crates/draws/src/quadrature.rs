//! Adaptive Gauss-Kronrod quadrature, from panels that leave nothing narrow out.

mod gauss_kronrod;
mod panels;
mod refine;

pub use gauss_kronrod::{Point, points};
pub use panels::{Panels, decays};

/// An integral and an estimate of its absolute error.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Integral {
    /// The Kronrod value.
    pub value: f64,
    /// The sum over the panels of |Kronrod - Gauss|, an overestimate for smooth functions.
    pub error: f64,
}

impl std::ops::AddAssign for Integral {
    fn add_assign(&mut self, other: Self) {
        self.value += other.value;
        self.error += other.error;
    }
}

/// The integral of `f` from `a` to `b`: [`Panels::new`] between the `features`, each halved until its two rules agree.
pub fn integrate(f: &dyn Fn(f64) -> f64, a: f64, b: f64, features: &[f64]) -> Integral {
    Panels::new(a, b, features).integrate(f)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_is_not_resolved_where_it_is_expected() {
        let looked = std::cell::Cell::new(0);
        let rounded = |t: f64| {
            looked.set(looked.get() + 1);
            (1.0 + 1e-9 * t) - (1.0 + 1e-9 * t).floor() - 1e-9 * t
        };
        let _ = integrate(&rounded, 0.0, 3.0, &[]);
        assert!(looked.replace(0) > 1_000_000, "this is noise");
        let noisy = Panels::new(0.0, 3.0, &[]).integrate_all(&|t| [rounded(t)], [3e-15])[0];
        assert!(looked.get() < 4000 && noisy.value.abs() < 1e-15, "{} {}", looked.get(), noisy.value);
    }

    #[test]
    fn smooth_and_broken_integrands_are_right() {
        let whole = integrate(&libm::exp, 0.0, 3.0, &[]);
        assert!((whole.value - (libm::exp(3.0) - 1.0)).abs() < 1e-13 * whole.value);
        let step = |t: f64| if t < 1.25 { 2.0 } else { 0.5 };
        let broken = integrate(&step, 0.0, 3.0, &[1.25]);
        assert!((broken.value - 3.375).abs() < 1e-14 && broken.error < 1e-13);
        assert!((integrate(&libm::sqrt, 0.0, 1.0, &[]).value - 2.0 / 3.0).abs() < 1e-12);
    }

    #[test]
    fn a_peak_between_the_nodes_of_one_panel_is_seen() {
        for width in [0.05, 0.01, 1e-3] {
            let peak = |t: f64| libm::exp(-0.5 * ((t - 1.31416) / width) * ((t - 1.31416) / width));
            let area = width * (2.0 * std::f64::consts::PI).sqrt();
            let found = integrate(&peak, 0.0, 2.0, &[]);
            assert!((found.value - area).abs() <= 1e-12 * area && found.error < 1e-11 * area, "{width} {found:?}");
        }
    }

    #[test]
    fn noise_ends_too() {
        let noise = |t: f64| libm::sin(1e15 * t);
        assert!(integrate(&noise, 0.0, 1.0, &[]).value.abs() < 0.1);
    }

    #[test]
    fn a_nan_is_not_hidden() {
        assert!(integrate(&|t| if t > 0.9 { f64::NAN } else { 1.0 }, 0.0, 1.0, &[]).value.is_nan());
    }
}

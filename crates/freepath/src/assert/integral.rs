//! One line for estimators of an integral.

use super::assert_experiment;
use freepath_estimators::Integrator;
use freepath_estimators::integral::Integrand;
use freepath_harness::kind::{InScene, Integral};
use std::panic::Location;

/// Panics unless the mean of `integrator` is the integral of `integrand`; see [`assert_free_path`](crate::assert_free_path).
///
/// ```
/// use freepath::integral::Integrand;
/// use freepath::{Integrator, assert_integral};
/// use rand::{Rng, RngExt};
///
/// struct Importance;
///
/// impl Integrator for Importance {
///     fn estimate(&self, integrand: &Integrand, rng: &mut dyn Rng) -> f64 {
///         let x = 2.0 * rng.random::<f64>().sqrt();
///         if x > 0.0 { integrand.f(x) / (x / 2.0) } else { 0.0 }
///     }
///     fn pdf(&self, _: &Integrand, x: f64) -> Option<f64> {
///         Some(x / 2.0)
///     }
/// }
///
/// assert_integral(&Importance, &Integrand::new("x*x + x", [0.0, 2.0], &[])?);
/// # Ok::<(), freepath::ParameterError>(())
/// ```
///
/// # Panics
/// If two rules of quadrature disagree on the integral, or the integrator refuses it; with what failed, by how much, with which p-value,
/// and how to replay it.
#[track_caller]
pub fn assert_integral(integrator: &impl Integrator, integrand: &Integrand) {
    let scene = match integrator.accepts(integrand).and_then(|()| Integral::scene_of(integrand.clone())) {
        Ok(scene) => scene,
        Err(why) => panic!("{why}"),
    };
    assert_experiment(&InScene::<Integral>::of(integrator, &scene), Location::caller());
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_draws::random::uniform;
    use rand::Rng;

    /// The mean of f alone, without the length of the domain.
    struct Forgetful;

    impl Integrator for Forgetful {
        fn estimate(&self, integrand: &Integrand, rng: &mut dyn Rng) -> f64 {
            integrand.f(2.0 * uniform(rng))
        }
    }

    #[test]
    #[should_panic(expected = "biased")]
    fn a_wrong_mean_panics() {
        assert_integral(&Forgetful, &Integrand::new("x*x + x", [0.0, 2.0], &[]).unwrap());
    }

    #[test]
    #[should_panic(expected = "two rules of quadrature disagree")]
    fn an_integral_that_is_infinite_panics() {
        assert_integral(&Forgetful, &Integrand::new("1/x", [0.0, 2.0], &[]).unwrap());
    }
}

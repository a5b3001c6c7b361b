//! A medium whose truth contradicts itself.

use crate::subject::{LENGTH, caught, in_medium, tracking};
use freepath_estimators::medium::Gaussian;
use freepath_estimators::{Extinction, Majorants, Medium};
use freepath_results::Reason;
use rand::{Rng, RngExt};

/// A bump whose truth is changed.
struct Changed {
    inner: Gaussian,
    tau: fn(&Gaussian, f64) -> f64,
    extrema: fn(&Gaussian, f64, f64) -> (f64, f64),
    tile: f64,
    breaks: Vec<f64>,
}

fn bump() -> Changed {
    let inner = Gaussian::new(4.0, 0.9, 0.25, LENGTH, 0.1).expect("a medium");
    Changed { inner, tau: Gaussian::tau, extrema: Gaussian::extrema, tile: 1.0, breaks: vec![] }
}

impl Extinction for Changed {
    fn length(&self) -> f64 {
        self.inner.length()
    }
    fn mu(&self, t: f64) -> f64 {
        self.inner.mu(t)
    }
    fn majorants(&self) -> &Majorants {
        self.inner.majorants()
    }
    fn breaks(&self) -> &[f64] {
        &self.breaks
    }
    fn mu_tile(&self, t: &[f64], mu: &mut [f64]) {
        self.inner.mu_tile(t, mu);
        mu.iter_mut().for_each(|mu| *mu *= self.tile);
    }
}

impl Medium for Changed {
    fn tau(&self, t: f64) -> f64 {
        (self.tau)(&self.inner, t)
    }
    fn extrema(&self, a: f64, b: f64) -> (f64, f64) {
        (self.extrema)(&self.inner, a, b)
    }
}

#[test]
fn a_medium_that_contradicts_itself_is_seen() {
    use freepath_harness::noiseless::medium;
    let says = |medium_: &dyn Medium, what: &str| {
        let fact = medium(medium_);
        assert!(fact.as_ref().is_some_and(|fact| fact.words.contains(what)), "{what}: {fact:?}");
    };
    assert_eq!(medium(&bump()), None);
    assert_eq!(medium(&freepath_estimators::medium::Constant::new(0.0, 2.0).expect("empty")), None);
    says(&Changed { tau: |inner, t| inner.tau(t) * (1.0 + 1e-6), ..bump() }, "has the integral");
    says(&Changed { tau: |inner, t| inner.tau(t) + 0.1, ..bump() }, "at 0");
    says(&Changed { tau: |_, _| f64::NAN, ..bump() }, "NaN");
    says(
        &Changed { extrema: |inner, a, b| (inner.extrema(a, b).0, inner.mu(0.5 * (a + b))), ..bump() },
        "extrema",
    );
    says(&Changed { tile: 1.0 + 1e-6, ..bump() }, "in a tile");
    says(&Changed { breaks: vec![1.0, 0.5], ..bump() }, "breaks");
    let facts = in_medium(
        &|medium: &dyn Extinction, rng: &mut dyn Rng| {
            tracking(medium, rng, |rng| -libm::log1p(-rng.random::<f64>()))
        },
        &Changed { tau: |inner, t| inner.tau(t) * (1.0 + 1e-6), ..bump() },
    );
    assert!(caught("identity_medium", Reason::SubjectError, &facts));
}

/// A bump as a user writes it: mu and a right tau, and no word of where it is narrow.
fn narrow(width: f64) -> Changed {
    let inner = Gaussian::new(40.0, 1.31416, width, LENGTH, 0.5).expect("a medium");
    Changed { inner, ..bump() }
}

#[test]
fn a_right_depth_of_a_bump_that_quadrature_misses_is_no_contradiction() {
    use freepath_harness::noiseless::medium;
    for width in [0.01, 3e-4 / std::f64::consts::SQRT_2, 1e-5, 1e-7] {
        assert_eq!(medium(&narrow(width)), None, "{width}");
        assert_eq!(medium(&narrow(width).inner), None, "{width}");
        let high = Changed { tau: |inner, t| inner.tau(t) * (1.0 + 1e-6), ..narrow(width) };
        assert!(medium(&high).is_some_and(|fact| fact.words.contains("has the integral")), "{width}");
    }
    let flat = Changed { tau: |_, t| 0.5 * t, ..narrow(3e-4) };
    assert!(medium(&flat).is_some_and(|fact| fact.words.contains("has the integral")), "a tau without the bump");
}

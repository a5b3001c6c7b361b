//! The integral, and the moments of an estimator that tells its density.

use freepath_draws::quadrature::Panels;
use freepath_estimators::integral::Integrand;
use freepath_estimators::{Integrator, ParameterError};

/// The highest moment.
const ORDERS: usize = 6;
/// The relative error beyond which two rules of quadrature disagree.
const MOST: f64 = 1e-7;

/// An integral that two rules agree on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Known {
    /// Its value.
    pub(super) value: f64,
    /// The most by which it may be off.
    pub(super) error: f64,
}

/// The integral of `f` over the domain; none where the rules disagree, as of one that does not exist.
fn integral(integrand: &Integrand, f: &dyn Fn(f64) -> f64) -> Option<Known> {
    let [a, b] = integrand.domain();
    let panels = Panels::new(a, b, integrand.breaks());
    let (first, finer) = (panels.integrate(f), panels.finer(4).integrate(f));
    let error = first.error + finer.error + (first.value - finer.value).abs();
    let size = panels.finer(4).integrate(&|x| f(x).abs()).value;
    (error <= MOST * size).then_some(Known { value: finer.value, error })
}

/// F.
///
/// # Errors
/// If the rules of quadrature disagree.
pub(super) fn truth(integrand: &Integrand) -> Result<Known, ParameterError> {
    let why = "its integral cannot be had: two rules of quadrature disagree (state `breaks`, or is it infinite?)";
    integral(integrand, &|x| integrand.f(x)).ok_or_else(|| ParameterError::unusable("f", why))
}

/// E[X^k] of one draw for k = 1 to 6, of a density that an estimator tells; none where that does not exist, or is not known.
///
/// ```text
/// E[X^k] = int f^k / p^(k-1)
/// ```
pub(super) fn moments(integrator: &dyn Integrator, integrand: &Integrand) -> Option<[Option<Known>; ORDERS]> {
    let [a, b] = integrand.domain();
    integrator.pdf(integrand, 0.5 * (a + b))?;
    let term = |x: f64, k: usize| {
        let (f, p) = (integrand.f(x), integrator.pdf(integrand, x).unwrap_or(f64::NAN));
        if f.abs() <= 0.0 { 0.0 } else { (1..k).fold(f, |product, _| product * (f / p)) }
    };
    let mut all = [None; ORDERS];
    for (k, moment) in all.iter_mut().enumerate() {
        *moment = integral(integrand, &|x| term(x, k + 1));
        if moment.is_none() {
            break; // where one does not exist, no higher one does
        }
    }
    Some(all)
}

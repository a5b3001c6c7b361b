use super::panels::{self, Panels};
use super::pieces;
use crate::extinction::{self, Extinction, Medium};
use crate::majorants::Majorants;
use crate::parameter::{self, ParameterError};
use freepath_draws::simd;
use std::sync::Arc;

/// The most that two rules of quadrature may put tau apart, relative to the whole.
const AGREEMENT: f64 = 1e-9;

/// A medium from any function: the one whose optical depth comes from quadrature. Made by [`numeric`].
///
/// ```text
/// tau(t) = sum of the panels before t, and a ten-point Gauss rule on the rest
/// ```
///
/// The panels lie between the given breaks, at least 256 of them, each halved until Gauss's and Romberg's rules agree
/// to 1e-13 of the whole; `tau_error` is twice what they leave between them.
///
/// Extrema are not exact. The greatest mu is the given majorant, everywhere. The least is the least of at least 16,384
/// samples, lowered by the largest step between neighbours in its panel, and 0 if that is negative. A feature narrower
/// than the samples are apart is not seen: hand in its place among the breaks.
#[derive(Clone)]
pub struct Numeric {
    mu: Arc<dyn Function>,
    length: f64,
    breaks: Vec<f64>,
    panels: Panels,
    majorants: Majorants,
}

/// A function of t, its loop over many compiled with it.
trait Function: Send + Sync {
    fn at(&self, t: f64) -> f64;
    fn tile(&self, t: &[f64], mu: &mut [f64]);
}

impl<F: Fn(f64) -> f64 + Send + Sync> Function for F {
    fn at(&self, t: f64) -> f64 {
        self(t)
    }
    fn tile(&self, t: &[f64], mu: &mut [f64]) {
        simd::dispatch(
            #[inline(always)]
            || {
                for (mu, &t) in mu.iter_mut().zip(t) {
                    *mu = self(t);
                }
            },
        );
    }
}

/// The medium of extinction `mu(t)`, at most `majorant`, for 0 <= t <= `length`; `mu` or its slope jumps at the `breaks`
/// and nowhere else.
///
/// # Errors
/// If mu is negative, NaN, infinite or above the majorant where it is sampled, the length is not positive, the breaks do
/// not increase inside (0, length), or two rules of quadrature differ by more than 1e-9 of tau(length).
pub fn numeric(
    mu: impl Fn(f64) -> f64 + Send + Sync + 'static,
    length: f64,
    majorant: f64,
    breaks: Vec<f64>,
) -> Result<Numeric, ParameterError> {
    parameter::positive("length", length)?;
    parameter::not_negative("majorant", majorant)?;
    check_breaks(&breaks, length)?;
    let panels = Panels::new(&|t| look_up(&mu, majorant, t), length, &breaks)?;
    let apart = panels.error / panels.depths.total();
    let agree = panels.error <= AGREEMENT * panels.depths.total();
    let must_be = "smooth between the breaks, so that rules of quadrature agree to 1e-9 of the whole";
    parameter::require(agree, "mu", format!("{apart:.1e} apart"), must_be)?;
    for &t in &breaks {
        look_up(&mu, majorant, t)?;
    }
    let unbounded =
        Numeric { mu: Arc::new(mu), length, breaks, panels, majorants: Majorants::constant(majorant, length) };
    Ok(Numeric { majorants: unbounded.majorants.clone().measured(&unbounded), ..unbounded })
}

fn check_breaks(breaks: &[f64], length: f64) -> Result<(), ParameterError> {
    let (count, most) = (breaks.len(), pieces::MOST - 1);
    let must_be = format!("at most {most} numbers");
    parameter::require(count <= most, "breaks", format!("{count} of them"), &must_be)?;
    let must_be = format!("increasing inside (0, {length})");
    let mut last = 0.0;
    for &t in breaks {
        last = parameter::require(t > last && t < length, "breaks", t, &must_be)?;
    }
    Ok(())
}

/// mu at `t`, if it can be one under the majorant.
fn look_up(mu: impl Fn(f64) -> f64, majorant: f64, t: f64) -> Result<f64, ParameterError> {
    let value = mu(t);
    if !(value >= 0.0 && value < f64::INFINITY) {
        let value = format!("{value} at t = {t}");
        return Err(ParameterError::new("mu", value, "finite and not negative"));
    }
    if value > majorant * (1.0 + 1e-12) {
        let value = format!("{majorant}, where mu is {value} at t = {t}");
        return Err(ParameterError::new("majorant", value, "an upper bound of mu"));
    }
    Ok(value)
}

impl Extinction for Numeric {
    fn length(&self) -> f64 {
        self.length
    }
    fn mu(&self, t: f64) -> f64 {
        self.mu.at(t)
    }
    fn majorants(&self) -> &Majorants {
        &self.majorants
    }
    fn breaks(&self) -> &[f64] {
        &self.breaks
    }
    fn mu_tile(&self, t: &[f64], mu: &mut [f64]) {
        self.mu.tile(t, mu);
    }
}

impl Medium for Numeric {
    fn tau(&self, t: f64) -> f64 {
        if t >= self.length {
            return self.panels.depths.total();
        }
        let k = self.panels.panel_of(t);
        let inside = panels::gauss(|s| self.mu.at(s), self.panels.edges[k], t);
        self.panels.depths.reach(k, inside)
    }
    fn tau_error(&self) -> f64 {
        2.0 * self.panels.error
    }
    fn features(&self) -> Vec<f64> {
        self.panels.features(self.length, &self.breaks)
    }
    fn inverse_tau(&self, depth: f64) -> f64 {
        let Panels { edges, depths, .. } = &self.panels;
        extinction::invert(depth, depths.total(), || {
            let (k, _) = depths.piece_of(depth);
            extinction::solve_between(self, depth, edges[k], edges[k + 1])
        })
    }
    fn extrema(&self, a: f64, b: f64) -> (f64, f64) {
        (self.panels.least(a, b), self.majorants.mu_bar()[0])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::medium::Gaussian;

    fn refusal(mu: impl Fn(f64) -> f64 + Send + Sync + 'static, breaks: &[f64]) -> String {
        let medium = numeric(mu, 3.0, 5.0, breaks.to_vec());
        medium.err().map(|why| why.to_string()).unwrap_or_default()
    }

    #[test]
    fn it_agrees_with_a_closed_form() {
        let truth = Gaussian::new(4.0, 0.9, 0.05, 2.3, 0.2).unwrap();
        let inner = truth.clone();
        let medium = numeric(move |t| inner.mu(t), 2.3, 4.2, vec![]).unwrap();
        for i in 0..=1000 {
            let t = 2.3 * f64::from(i) / 1000.0;
            assert!((medium.tau(t) - truth.tau(t)).abs() <= 1e-13, "{t}");
        }
        assert!(medium.tau_error() < 1e-12);
        let (low, high) = medium.extrema(0.0, 2.3);
        assert!(low <= 0.2 && low > 0.19 && high >= 4.2);
    }

    #[test]
    fn jumps_at_breaks_and_singular_slopes_are_integrated() {
        let step = |t: f64| if t < 1.25 { 2.0 } else { 0.5 * (t - 1.25).sqrt() };
        let medium = numeric(step, 3.0, 2.0, vec![1.25]).unwrap();
        let total = 2.5 + 1.75f64.sqrt() * 1.75 / 3.0;
        assert!((medium.tau(3.0) - total).abs() < 1e-13);
        assert!((medium.inverse_tau(2.0) - 1.0).abs() < 1e-14);
    }

    #[test]
    fn bad_values_are_refused_with_their_place() {
        let negative = refusal(|t| t - 1.5, &[]);
        assert_eq!(negative, "mu must be finite and not negative, not -1.5 at t = 0");
        assert!(refusal(|t| if t > 2.0 { f64::NAN } else { 1.0 }, &[]).contains("not NaN at t = 2.0"));
        assert!(refusal(|t| 1.0 / t, &[]).contains("not inf at t = 0"));
        let short = refusal(|t| 2.0 * t, &[]);
        assert!(short.starts_with("majorant must be an upper bound of mu, not 5, where mu is 5.0"));
        assert!(short.contains(" at t = 2.5"));
    }

    #[test]
    fn what_cannot_be_integrated_is_refused() {
        let noise = |t: f64| (t.to_bits().wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 12) as f64 / 2f64.powi(52);
        assert!(refusal(noise, &[]).starts_with("mu must be smooth between the breaks"));
        assert_eq!(refusal(|_| 1.0, &[2.0, 1.0]), "breaks must be increasing inside (0, 3), not 1");
        assert!(refusal(|_| 1.0, &[3.0]).ends_with("not 3"));
    }
}

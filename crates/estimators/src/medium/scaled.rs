use super::{AnyMedium, Built, Describe, Resolver};
use crate::extinction::{self, Cells, Extinction, Medium};
use crate::majorants::Majorants;
use crate::parameter::{self, ParameterError};
use std::sync::Arc;

/// A medium made denser or thinner; of a chromatic one, every channel.
///
/// ```text
/// mu(t) = by mu'(t),   tau(t) = by tau'(t),   tau^-1(x) = tau'^-1(x / by)
/// ```
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(try_from = "Parameters", into = "Parameters")]
pub struct Scaled {
    parameters: Parameters,
}

#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "scaled")]
struct Parameters {
    /// The factor of the extinction.
    by: f64,
    /// The medium that is scaled.
    medium: Box<AnyMedium>,
}

impl Scaled {
    /// `medium` with its extinction multiplied by `by`.
    ///
    /// # Errors
    /// If `by` is negative or not finite.
    pub fn new(by: f64, medium: AnyMedium) -> Result<Self, ParameterError> {
        let medium = Box::new(medium);
        Self::try_from(Parameters { by, medium })
    }
}

impl TryFrom<Parameters> for Scaled {
    type Error = ParameterError;

    fn try_from(parameters: Parameters) -> Result<Self, ParameterError> {
        parameter::not_negative("by", parameters.by)?;
        Ok(Self { parameters })
    }
}

impl From<Scaled> for Parameters {
    fn from(medium: Scaled) -> Self {
        medium.parameters
    }
}

impl Describe for Scaled {
    fn build(&self, resolver: &dyn Resolver) -> Result<Built, ParameterError> {
        let Parameters { by, medium } = &self.parameters;
        Ok(match medium.build(resolver)? {
            Built::Grey(inner) => Built::Grey(Arc::new(View::new(*by, inner)?)),
            Built::Chromatic(inner) => Built::Chromatic(inner.with(*by, inner.length())?),
        })
    }
}

/// `inner` with its extinction and majorants multiplied by `by`: [`Scaled`] for any medium.
///
/// # Errors
/// If `by` is negative or not finite, or extinction would not stay finite.
pub fn scaled<M: Medium>(by: f64, inner: M) -> Result<impl Medium, ParameterError> {
    parameter::not_negative("by", by)?;
    View::new(by, inner)
}

struct View<M> {
    by: f64,
    inner: M,
    majorants: Majorants,
}

impl<M: Medium> View<M> {
    fn new(by: f64, inner: M) -> Result<Self, ParameterError> {
        let (_, greatest) = inner.extrema(0.0, inner.length());
        let finite = (by * greatest).is_finite();
        parameter::require(finite, "by", by, "small enough for extinction to stay finite")?;
        let majorants = inner.majorants().map(|mu| by * mu);
        Ok(Self { by, inner, majorants })
    }
}

impl<M: Medium> Extinction for View<M> {
    fn length(&self) -> f64 {
        self.inner.length()
    }
    fn mu(&self, t: f64) -> f64 {
        self.by * self.inner.mu(t)
    }
    fn majorants(&self) -> &Majorants {
        &self.majorants
    }
    fn breaks(&self) -> &[f64] {
        self.inner.breaks()
    }
    fn cells(&self) -> Cells {
        self.inner.cells()
    }
    fn mu_tile(&self, t: &[f64], mu: &mut [f64]) {
        self.inner.mu_tile(t, mu);
        for mu in mu.iter_mut().take(t.len()) {
            *mu *= self.by;
        }
    }
}

impl<M: Medium> Medium for View<M> {
    fn tau(&self, t: f64) -> f64 {
        self.by * self.inner.tau(t)
    }
    fn tau_error(&self) -> f64 {
        self.by * self.inner.tau_error()
    }
    fn features(&self) -> Vec<f64> {
        self.inner.features()
    }
    fn inverse_tau(&self, depth: f64) -> f64 {
        let length = self.length();
        extinction::invert(depth, self.tau(length), || {
            let t = self.inner.inverse_tau(depth / self.by);
            if t < length { t } else { length }
        })
    }
    fn extrema(&self, a: f64, b: f64) -> (f64, f64) {
        let (low, high) = self.inner.extrema(a, b);
        (self.by * low, self.by * high)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::medium::Linear;

    #[test]
    fn values_by_hand() {
        let inner = Linear::new(0.5, 2.0, 3.0).unwrap();
        let view = View::new(4.0, Arc::new(inner)).unwrap();
        assert_eq!((view.mu(1.0), view.tau(1.0), view.tau(3.0)), (4.0, 3.0, 15.0));
        assert!((view.inverse_tau(3.0) - 1.0).abs() < 1e-15);
        assert_eq!(view.extrema(0.0, 1.0), (2.0, 4.0));
        let majorants = view.majorants();
        assert_eq!((majorants.mu_bar(), majorants.mu_min()), (&[8.0][..], &[2.0][..]));
        assert_eq!(majorants.mu_mean(), [5.0]);
    }

    #[test]
    fn a_bad_factor_is_refused() {
        let medium = || AnyMedium::Linear(Linear::new(0.5, 2.0, 3.0).unwrap());
        let refusal = |by| Scaled::new(by, medium()).unwrap_err().to_string();
        assert_eq!(refusal(-2.0), "by must be finite and not negative, not -2");
        assert_eq!(refusal(f64::NAN), "by must be finite and not negative, not NaN");
    }
}

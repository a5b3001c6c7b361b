use super::ramp::Ramp;
use crate::extinction::{self, Cells, Extinction, Medium};
use crate::majorants::Majorants;
use crate::parameter::{self, ParameterError};

/// Extinction that changes linearly from one end of the ray to the other.
///
/// ```text
/// mu(t)     = mu0 + (mu1 - mu0) t / length
/// tau(t)    = mu0 t + (mu1 - mu0) t^2 / (2 length)
/// tau^-1(x) = 2 x / (mu0 + sqrt(mu0^2 + 2 x (mu1 - mu0) / length))
/// ```
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(try_from = "Parameters", into = "Parameters")]
pub struct Linear {
    parameters: Parameters,
    ramp: Ramp,
    majorants: Majorants,
}

#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "linear")]
struct Parameters {
    /// Extinction at the start, 1/length.
    mu0: f64,
    /// Extinction at the end, 1/length.
    mu1: f64,
    /// Length of the ray.
    length: f64,
}

impl Linear {
    /// Extinction from `mu0` to `mu1` over `length`.
    ///
    /// # Errors
    /// If mu0 or mu1 is negative, the length is not positive, or any of them is not finite.
    pub fn new(mu0: f64, mu1: f64, length: f64) -> Result<Self, ParameterError> {
        Self::try_from(Parameters { mu0, mu1, length })
    }
}

impl TryFrom<Parameters> for Linear {
    type Error = ParameterError;

    fn try_from(parameters: Parameters) -> Result<Self, ParameterError> {
        let ramp = Ramp {
            from: parameter::not_negative("mu0", parameters.mu0)?,
            to: parameter::not_negative("mu1", parameters.mu1)?,
            width: parameter::positive("length", parameters.length)?,
        };
        let unbounded = Self { parameters, ramp, majorants: Majorants::default() };
        Ok(Self { majorants: Majorants::tight(&unbounded, 1), ..unbounded })
    }
}

impl From<Linear> for Parameters {
    fn from(medium: Linear) -> Self {
        medium.parameters
    }
}

impl Extinction for Linear {
    fn length(&self) -> f64 {
        self.parameters.length
    }
    #[inline(always)]
    fn mu(&self, t: f64) -> f64 {
        self.ramp.mu(t)
    }
    fn majorants(&self) -> &Majorants {
        &self.majorants
    }
    fn cells(&self) -> Cells {
        Cells::Linear
    }
}

impl Medium for Linear {
    fn tau(&self, t: f64) -> f64 {
        self.ramp.tau(t)
    }
    fn inverse_tau(&self, depth: f64) -> f64 {
        let total = self.tau(self.length());
        extinction::invert(depth, total, || self.ramp.inverse_tau(depth))
    }
    fn tau_error(&self) -> f64 {
        0.0
    }
    fn extrema(&self, a: f64, b: f64) -> (f64, f64) {
        super::pieces::extrema([self.mu(a), self.mu(b)].into_iter())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_by_hand() {
        let ramp = Linear::new(0.5, 2.0, 3.0).unwrap();
        assert_eq!((ramp.mu(0.0), ramp.mu(1.0), ramp.mu(3.0)), (0.5, 1.0, 2.0));
        assert_eq!((ramp.tau(1.0), ramp.tau(3.0)), (0.75, 3.75));
        assert!((ramp.inverse_tau(0.75) - 1.0).abs() < 1e-15);
        assert!(ramp.inverse_tau(3.75).is_infinite());
        assert_eq!(ramp.extrema(1.0, 3.0), (1.0, 2.0));
        assert_eq!(ramp.majorants().mu_bar(), [2.0]);
        assert_eq!(ramp.majorants().mu_mean(), [1.25]);
    }

    #[test]
    fn a_ramp_to_nothing_inverts_up_to_its_end() {
        let ramp = Linear::new(2.0, 0.0, 3.0).unwrap();
        assert_eq!(ramp.mu(3.0).to_bits(), 0f64.to_bits());
        let t = ramp.inverse_tau(3.0f64.next_down());
        assert!(t > 3.0 - 1e-7 && t <= 3.0);
    }
}

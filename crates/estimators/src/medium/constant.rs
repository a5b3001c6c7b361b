use crate::extinction::{Cells, Extinction, Medium, invert};
use crate::majorants::Majorants;
use crate::parameter::{self, ParameterError};

/// A homogeneous medium: mu(t) = mu.
///
/// ```text
/// tau(t) = mu t,   tau^-1(x) = x / mu
/// ```
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(try_from = "Parameters", into = "Parameters")]
pub struct Constant {
    parameters: Parameters,
    majorants: Majorants,
}

#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "constant")]
struct Parameters {
    /// Extinction, 1/length.
    mu: f64,
    /// Length of the ray.
    length: f64,
}

impl Constant {
    /// Extinction `mu` over `length`.
    ///
    /// # Errors
    /// If mu is negative, the length is not positive, or either is not finite.
    pub fn new(mu: f64, length: f64) -> Result<Self, ParameterError> {
        Self::try_from(Parameters { mu, length })
    }
}

impl TryFrom<Parameters> for Constant {
    type Error = ParameterError;

    fn try_from(parameters: Parameters) -> Result<Self, ParameterError> {
        parameter::not_negative("mu", parameters.mu)?;
        parameter::positive("length", parameters.length)?;
        let unbounded = Self { parameters, majorants: Majorants::default() };
        Ok(Self { majorants: Majorants::tight(&unbounded, 1), ..unbounded })
    }
}

impl From<Constant> for Parameters {
    fn from(medium: Constant) -> Self {
        medium.parameters
    }
}

impl Extinction for Constant {
    fn length(&self) -> f64 {
        self.parameters.length
    }
    #[inline(always)]
    fn mu(&self, _t: f64) -> f64 {
        self.parameters.mu
    }
    fn majorants(&self) -> &Majorants {
        &self.majorants
    }
    fn cells(&self) -> Cells {
        Cells::Constant
    }
}

impl Medium for Constant {
    fn tau(&self, t: f64) -> f64 {
        self.parameters.mu * t
    }
    fn inverse_tau(&self, depth: f64) -> f64 {
        let (mu, length) = (self.parameters.mu, self.parameters.length);
        invert(depth, self.tau(length), || {
            let t = depth / mu;
            if t < length { t } else { length }
        })
    }
    fn tau_error(&self) -> f64 {
        0.0
    }
    fn extrema(&self, _a: f64, _b: f64) -> (f64, f64) {
        (self.parameters.mu, self.parameters.mu)
    }
}

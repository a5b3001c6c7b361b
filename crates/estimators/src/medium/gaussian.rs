use super::view;
use crate::extinction::{Extinction, Medium};
use crate::majorants::Majorants;
use crate::parameter::{self, ParameterError};
use freepath_draws::math;
use std::f64::consts::{FRAC_PI_2, SQRT_2};

/// Where the flanks of the bump are split, in widths from the center: from the last one on it is below the least f64.
const FLANKS: [f64; 14] = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 12.0, 17.0, 25.0, 39.0];

/// A Gaussian bump over a constant base.
///
/// ```text
/// mu(t)  = base + peak exp(-((t - center) / width)^2 / 2)
/// tau(t) = base t + peak width sqrt(pi / 2) [erf((t - center) / (width sqrt 2)) + erf(center / (width sqrt 2))]
/// ```
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(try_from = "Parameters", into = "Parameters")]
pub struct Gaussian {
    parameters: Parameters,
    per_width: f64,
    majorants: Majorants,
}

#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "gaussian")]
struct Parameters {
    /// Height of the bump above the base, 1/length.
    peak: f64,
    /// The place where the bump is highest.
    center: f64,
    /// Standard deviation of the bump.
    width: f64,
    /// Length of the ray.
    length: f64,
    /// Extinction far from the bump, 1/length.
    #[serde(default)]
    base: f64,
}

impl Gaussian {
    /// A bump of height `peak` and standard deviation `width` at `center`, over `base`, on a ray of `length`.
    ///
    /// # Errors
    /// If peak or base is negative, width or length not positive, or any of them not finite.
    pub fn new(peak: f64, center: f64, width: f64, length: f64, base: f64) -> Result<Self, ParameterError> {
        Self::try_from(Parameters { peak, center, width, length, base })
    }
}

impl TryFrom<Parameters> for Gaussian {
    type Error = ParameterError;

    fn try_from(parameters: Parameters) -> Result<Self, ParameterError> {
        parameter::not_negative("peak", parameters.peak)?;
        parameter::finite("center", parameters.center)?;
        let per_width = 1.0 / parameter::positive("width", parameters.width)?;
        parameter::require(per_width.is_finite(), "width", parameters.width, "a normal number")?;
        parameter::positive("length", parameters.length)?;
        parameter::not_negative("base", parameters.base)?;
        let unbounded = Self { parameters, per_width, majorants: Majorants::default() };
        Ok(Self { majorants: Majorants::tight(&unbounded, 1), ..unbounded })
    }
}

impl From<Gaussian> for Parameters {
    fn from(medium: Gaussian) -> Self {
        medium.parameters
    }
}

impl Extinction for Gaussian {
    fn length(&self) -> f64 {
        self.parameters.length
    }
    #[inline(always)]
    fn mu(&self, t: f64) -> f64 {
        let x = (t - self.parameters.center) * self.per_width;
        self.parameters.base + self.parameters.peak * math::exp(-0.5 * x * x)
    }
    fn majorants(&self) -> &Majorants {
        &self.majorants
    }
}

impl Medium for Gaussian {
    fn tau(&self, t: f64) -> f64 {
        let Parameters { peak, center, width, base, .. } = self.parameters;
        let q = width * SQRT_2;
        base * t + peak * width * FRAC_PI_2.sqrt() * (libm::erf((t - center) / q) + libm::erf(center / q))
    }
    fn tau_error(&self) -> f64 {
        0.0
    }
    fn features(&self) -> Vec<f64> {
        let Parameters { center, width, length, .. } = self.parameters;
        let flanks = FLANKS.iter().rev().map(|x| center - x * width);
        view::inside(flanks.chain(FLANKS[1..].iter().map(|x| center + x * width)), length)
    }
    fn extrema(&self, a: f64, b: f64) -> (f64, f64) {
        let (left, right) = (self.mu(a), self.mu(b));
        let (low, high) = if left < right { (left, right) } else { (right, left) };
        let inside = a <= self.parameters.center && self.parameters.center <= b;
        (low, if inside { self.parameters.base + self.parameters.peak } else { high })
    }
}

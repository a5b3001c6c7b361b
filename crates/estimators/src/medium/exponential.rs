use crate::extinction::{self, Extinction, Medium};
use crate::majorants::Majorants;
use crate::parameter::{self, ParameterError};
use freepath_draws::{math, quadrature};

/// An atmosphere: extinction that falls exponentially, or grows if the scale height is negative.
///
/// ```text
/// mu(t)     = mu0 exp(-t / scale_height)
/// tau(t)    = mu0 scale_height (1 - exp(-t / scale_height))
/// tau^-1(x) = -scale_height ln(1 - x / (mu0 scale_height))
/// ```
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(try_from = "Parameters", into = "Parameters")]
pub struct Exponential {
    parameters: Parameters,
    per_height: f64,
    majorants: Majorants,
}

#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "exponential")]
struct Parameters {
    /// Extinction at the start, 1/length.
    mu0: f64,
    /// The length over which extinction falls by e; negative if it grows.
    scale_height: f64,
    /// Length of the ray.
    length: f64,
}

impl Exponential {
    /// Extinction `mu0` at the start, falling by e every `scale_height`, over `length`.
    ///
    /// # Errors
    /// If mu0 is negative, the scale height 0, the length not positive, any of them not finite, or if extinction grows
    /// by more than exp(700).
    pub fn new(mu0: f64, scale_height: f64, length: f64) -> Result<Self, ParameterError> {
        Self::try_from(Parameters { mu0, scale_height, length })
    }
}

impl TryFrom<Parameters> for Exponential {
    type Error = ParameterError;

    fn try_from(parameters: Parameters) -> Result<Self, ParameterError> {
        let Parameters { mu0, scale_height, length } = parameters;
        parameter::not_negative("mu0", mu0)?;
        parameter::positive("length", length)?;
        let per_height = 1.0 / parameter::finite("scale_height", scale_height)?;
        let usable = per_height.is_finite();
        parameter::require(usable, "scale_height", scale_height, "finite and not 0")?;
        let last = mu0 * libm::exp(-length * per_height);
        let bounded = -length * per_height <= 700.0 && last.is_finite();
        let must_be = "such that extinction grows by at most exp(700) and stays finite";
        parameter::require(bounded, "scale_height", scale_height, must_be)?;
        let unbounded = Self { parameters, per_height, majorants: Majorants::default() };
        Ok(Self { majorants: Majorants::tight(&unbounded, 1), ..unbounded })
    }
}

impl From<Exponential> for Parameters {
    fn from(medium: Exponential) -> Self {
        medium.parameters
    }
}

impl Extinction for Exponential {
    fn length(&self) -> f64 {
        self.parameters.length
    }
    #[inline(always)]
    fn mu(&self, t: f64) -> f64 {
        self.parameters.mu0 * math::exp(-t * self.per_height)
    }
    fn majorants(&self) -> &Majorants {
        &self.majorants
    }
}

impl Medium for Exponential {
    fn tau(&self, t: f64) -> f64 {
        let height = self.parameters.scale_height;
        self.parameters.mu0 * (-height * libm::expm1(-t / height))
    }
    fn inverse_tau(&self, depth: f64) -> f64 {
        let Parameters { mu0, scale_height, length } = self.parameters;
        extinction::invert(depth, self.tau(length), || {
            let t = -scale_height * libm::log1p(-(depth / mu0) / scale_height);
            if t < length { t } else { length }
        })
    }
    fn tau_error(&self) -> f64 {
        0.0
    }
    fn features(&self) -> Vec<f64> {
        quadrature::decays(self.parameters.length, &[self.per_height.abs()])
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
        let falling = Exponential::new(3.0, 0.5, 2.0).unwrap();
        assert!((falling.mu(0.5) - 1.103_638_323_514_327).abs() < 1e-15);
        assert!((falling.tau(2.0) - 1.5 * (1.0 - 0.018_315_638_888_734_18)).abs() < 1e-15);
        assert!((falling.inverse_tau(0.75) - 0.5 * std::f64::consts::LN_2).abs() < 1e-15);
        assert!((falling.inverse_tau(3e-20) / 1e-20 - 1.0).abs() < 1e-15);
        assert_eq!(falling.majorants().mu_bar(), [3.0]);
    }

    #[test]
    fn a_negative_scale_height_grows() {
        let growing = Exponential::new(0.1, -0.5, 2.0).unwrap();
        let most = 0.1 * 54.598_150_033_144_236;
        assert!((growing.mu(2.0) - most).abs() < 1e-14 * most);
        assert!((growing.tau(2.0) - 0.05 * 53.598_150_033_144_236).abs() < 1e-14);
        assert_eq!(growing.extrema(0.0, 2.0), (0.1, growing.mu(2.0)));
    }

    #[test]
    fn a_very_great_height_is_a_constant() {
        let flat = Exponential::new(0.7, 1e300, 3.0).unwrap();
        assert!((flat.tau(3.0) - 2.1).abs() < 1e-15);
        assert!((flat.inverse_tau(1.4) - 2.0).abs() < 1e-15);
    }

    #[test]
    fn a_height_of_nothing_and_endless_growth_are_refused() {
        let refusal = |height| Exponential::new(1.0, height, 2.0).unwrap_err().to_string();
        assert_eq!(refusal(0.0), "scale_height must be finite and not 0, not 0");
        assert_eq!(refusal(f64::NAN), "scale_height must be finite, not NaN");
        assert!(refusal(-1e-3).ends_with("stays finite, not -0.001"));
    }
}

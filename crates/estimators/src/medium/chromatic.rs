use super::chromatic_medium::{ChromaticMedium, Coefficients};
use super::describe::{Built, Describe, Resolver};
use crate::parameter::{self, ParameterError};

/// A homogeneous medium of several channels.
///
/// ```text
/// mu_c(t) = sigma_t[c],   albedo_c = sigma_s[c] / sigma_t[c]   (0 in an empty channel)
/// ```
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(try_from = "Parameters", into = "Parameters")]
pub struct Chromatic {
    parameters: Parameters,
    medium: ChromaticMedium,
}

#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "chromatic")]
struct Parameters {
    /// Extinction of each channel, 1/length.
    sigma_t: Vec<f64>,
    /// Scattering of each channel, 1/length, at most the extinction.
    sigma_s: Vec<f64>,
    /// Length of the ray.
    length: f64,
}

impl Chromatic {
    /// Channels of extinction `sigma_t` and scattering `sigma_s` over `length`.
    ///
    /// # Errors
    /// If there are none or more than 64 channels, not as many of one as of the other, an extinction is negative, none is
    /// positive, scattering exceeds extinction, the length is not positive, or any number is not finite.
    pub fn new(sigma_t: Vec<f64>, sigma_s: Vec<f64>, length: f64) -> Result<Self, ParameterError> {
        Self::try_from(Parameters { sigma_t, sigma_s, length })
    }
}

impl Chromatic {
    /// The channels over their length.
    #[must_use]
    pub fn medium(&self) -> &ChromaticMedium {
        &self.medium
    }
}

impl TryFrom<Parameters> for Chromatic {
    type Error = ParameterError;

    fn try_from(parameters: Parameters) -> Result<Self, ParameterError> {
        let Parameters { sigma_t, sigma_s, length } = &parameters;
        parameter::positive("length", *length)?;
        let given = format!("{} of them", sigma_s.len());
        let must_be = "as many as the channels of sigma_t";
        parameter::require(sigma_s.len() == sigma_t.len(), "sigma_s", given, must_be)?;
        let mut channels = vec![];
        for (&mu, &scattering) in sigma_t.iter().zip(sigma_s) {
            parameter::not_negative("sigma_t", mu)?;
            let allowed = parameter::not_negative("sigma_s", scattering)? <= mu;
            let must_be = format!("at most the sigma_t of its channel, {mu}");
            parameter::require(allowed, "sigma_s", scattering, &must_be)?;
            let albedo = if mu > 0.0 { scattering / mu } else { 0.0 };
            channels.push(Coefficients { mu, albedo });
        }
        let medium = ChromaticMedium::new(&channels, *length)?;
        Ok(Self { parameters, medium })
    }
}

impl From<Chromatic> for Parameters {
    fn from(medium: Chromatic) -> Self {
        medium.parameters
    }
}

impl Describe for Chromatic {
    fn build(&self, _resolver: &dyn Resolver) -> Result<Built, ParameterError> {
        Ok(Built::Chromatic(self.medium.clone()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn channels_carry_extinction_and_albedo() {
        let medium = Chromatic::new(vec![2.0, 0.5, 0.0], vec![1.5, 0.5, 0.0], 3.0).unwrap();
        let channels = medium.medium.channels();
        let seen: Vec<(f64, f64)> =
            channels.iter().map(|channel| (channel.extinction.mu(1.0), channel.albedo)).collect();
        assert_eq!(seen, [(2.0, 0.75), (0.5, 1.0), (0.0, 0.0)]);
        assert_eq!((medium.medium.length(), channels[0].extinction.length()), (3.0, 3.0));
    }

    #[test]
    fn bad_channels_are_refused() {
        let refusal = |sigma_t: &[f64], sigma_s: &[f64]| {
            let medium = Chromatic::new(sigma_t.to_vec(), sigma_s.to_vec(), 3.0);
            medium.unwrap_err().to_string()
        };
        assert_eq!(
            refusal(&[1.0, 2.0], &[1.0, 2.5]),
            "sigma_s must be at most the sigma_t of its channel, 2, not 2.5"
        );
        assert_eq!(refusal(&[1.0], &[]), "sigma_s must be as many as the channels of sigma_t, not 0 of them");
        assert_eq!(refusal(&[], &[]), "sigma_t must be from 1 to 64 channels, not 0 of them");
        assert_eq!(refusal(&[0.0; 2], &[0.0; 2]), "sigma_t must be positive in at least one channel, not 0");
        assert!(refusal(&[f64::NAN], &[0.0]).ends_with("not NaN"));
        assert!(refusal(&[1.0; 65], &[0.0; 65]).ends_with("not 65 of them"));
    }
}

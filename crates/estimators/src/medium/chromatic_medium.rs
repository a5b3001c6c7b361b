use super::constant::Constant;
use crate::claims::Channel;
use crate::extinction::Extinction;
use crate::parameter::{self, ParameterError};

/// The most channels that a medium may have.
const MOST_CHANNELS: usize = 64;

/// A channel of a homogeneous medium.
#[derive(Clone, Debug, PartialEq)]
pub struct ChannelMedium {
    /// Extinction along the ray.
    pub extinction: Constant,
    /// Scattering over extinction.
    pub albedo: f64,
}

impl ChannelMedium {
    /// The channel as a sampler sees it.
    fn seen(&self) -> Channel<'_> {
        Channel { extinction: &self.extinction, albedo: self.albedo }
    }
}

/// Extinction and albedo of a channel that is to be made.
#[derive(Clone, Copy)]
pub(super) struct Coefficients {
    pub(super) mu: f64,
    pub(super) albedo: f64,
}

/// Homogeneous channels over one length, at least one of which absorbs or scatters.
#[derive(Clone, Debug, PartialEq)]
pub struct ChromaticMedium {
    channels: Vec<ChannelMedium>,
    length: f64,
}

impl ChromaticMedium {
    /// The medium with these channels.
    pub(super) fn new(channels: &[Coefficients], length: f64) -> Result<Self, ParameterError> {
        let count = channels.len();
        let must_be = format!("from 1 to {MOST_CHANNELS} channels");
        let allowed = count >= 1 && count <= MOST_CHANNELS;
        parameter::require(allowed, "sigma_t", format!("{count} of them"), &must_be)?;
        let filled = channels.iter().any(|channel| channel.mu > 0.0);
        parameter::require(filled, "sigma_t", "0", "positive in at least one channel")?;
        let channel =
            |&Coefficients { mu, albedo }| Ok(ChannelMedium { extinction: Constant::new(mu, length)?, albedo });
        let channels = channels.iter().map(channel).collect::<Result<_, _>>()?;
        Ok(Self { channels, length })
    }

    /// The length of the ray.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Extinction and albedo of each channel.
    #[must_use]
    pub fn media(&self) -> &[ChannelMedium] {
        &self.channels
    }

    /// The channels as a sampler sees them.
    #[must_use]
    pub fn channels(&self) -> Vec<Channel<'_>> {
        self.channels.iter().map(ChannelMedium::seen).collect()
    }

    /// The same albedos with extinction `by` times as great, over `length`.
    ///
    /// # Errors
    /// If extinction would not be finite, or the length is not positive.
    pub fn with(&self, by: f64, length: f64) -> Result<Self, ParameterError> {
        let scaled =
            |channel: &ChannelMedium| Coefficients { mu: by * channel.extinction.mu(0.0), albedo: channel.albedo };
        let channels: Vec<Coefficients> = self.channels.iter().map(scaled).collect();
        Self::new(&channels, length)
    }
}

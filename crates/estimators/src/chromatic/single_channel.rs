use super::block::{self, Heuristic, Own};
use super::mixture::{self, Probabilities};
use crate::capability::Capability;
use crate::chromatic::ChromaticSampler;
use crate::claims::{Channel, ChromaticClaims};
use crate::parameter::{self, ParameterError};
use freepath_draws::{Draws, Streams};

/// A distance from one channel, divided by that channel's density alone: no heuristic.
///
/// ```text
/// w_k = f_k(t) / p_i(t),   channel i given, or drawn with probability q_i
/// p_j = sigma_j exp(-sigma_j t) and f_k = albedo_k p_k scattered;   p_k = f_k = exp(-sigma_k length) at the surface
/// E[w_k^p] = int f_k^p sum_i q_i / p_i^(p-1) dt
/// ```
///
/// Target: mean albedo_k (1 - T_k) scattered and T_k at the surface, in each channel k.
/// Range:  not negative; large where channel k is much thinner than channel i.
/// Cost:   one uniform if the channel is given, else two.
/// Needs:  homogeneous channels of one length; none that is drawn transparent.
#[doc(alias = "hero_wavelength")]
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(try_from = "Parameters", into = "Parameters")]
pub struct SingleChannel {
    channel: Option<usize>,
    probabilities: Probabilities,
}

#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "single_channel")]
struct Parameters {
    /// The channel that is always drawn, counted from 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    channel: Option<usize>,
    /// The probability of drawing each channel: not negative, of sum 1, one for each channel; all alike if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    channel_probabilities: Option<Vec<f64>>,
}

impl SingleChannel {
    /// Always this channel.
    #[must_use]
    pub fn always(channel: usize) -> Self {
        let channel = Some(channel);
        Self { channel, ..Self::default() }
    }

    /// Channels drawn with these probabilities, or all alike.
    ///
    /// # Errors
    /// If one is negative or NaN, or their sum is not 1.
    pub fn drawn(channel_probabilities: Option<Vec<f64>>) -> Result<Self, ParameterError> {
        let probabilities = Probabilities::new(channel_probabilities)?;
        Ok(Self { channel: None, probabilities })
    }

    /// The probabilities of `n` channels.
    fn mixture(&self, n: usize) -> Vec<f64> {
        match self.channel {
            Some(channel) => (0..n).map(|k| f64::from(u8::from(k == channel))).collect(),
            None => self.probabilities.all(n),
        }
    }
}

impl TryFrom<Parameters> for SingleChannel {
    type Error = ParameterError;

    fn try_from(parameters: Parameters) -> Result<Self, ParameterError> {
        match parameters.channel {
            None => Self::drawn(parameters.channel_probabilities),
            Some(channel) => {
                let alone = parameters.channel_probabilities.is_none();
                parameter::require(alone, "channel", channel, "absent where channel_probabilities are given")?;
                Ok(Self::always(channel))
            }
        }
    }
}

impl From<SingleChannel> for Parameters {
    fn from(sampler: SingleChannel) -> Self {
        Self {
            channel: sampler.channel,
            channel_probabilities: sampler.probabilities.given().map(<[f64]>::to_vec),
        }
    }
}

impl Heuristic for SingleChannel {
    #[inline(always)]
    fn add(&self, sum: f64, _share: f64, _own: Own) -> f64 {
        sum
    }

    #[inline(always)]
    fn divisor(&self, _sum: f64, own: Own) -> f64 {
        own.density
    }
}

impl ChromaticSampler for SingleChannel {
    fn sample(&self, channels: &[Channel], rng: &mut dyn rand::Rng, weights: &mut [f64]) -> f64 {
        let drawn = match self.channel {
            Some(channel) => channel,
            None => self.probabilities.draw(channels.len(), rng),
        };
        let t = mixture::distance(&channels[drawn], rng);
        let pdf = mixture::density(&channels[drawn], t);
        for (weight, channel) in weights.iter_mut().zip(channels) {
            *weight = mixture::contribution(channel, t) / pdf;
        }
        t
    }

    fn sample_block(&self, channels: &[Channel], streams: &Streams, out: &mut Draws) {
        block::draws(self, channels, &self.mixture(channels.len()), streams, out);
    }

    fn pdf(&self, channels: &[Channel], t: f64) -> Option<f64> {
        Some(mixture::pdf(channels, &self.mixture(channels.len()), t))
    }

    fn claims(&self, channels: &[Channel]) -> ChromaticClaims {
        let q = self.mixture(channels.len());
        let moments = |f: f64, t: f64, order| {
            let drawn = channels.iter().zip(&q).filter(|&(_, &q)| q > 0.0);
            let term = |(channel, q): (&Channel, &f64)| {
                let pdf = mixture::density(channel, t);
                q * pdf * mixture::even_power(f / pdf, order)
            };
            drawn.map(term).sum()
        };
        let always = q.iter().filter(|&&q| q > 0.0).count() == 1;
        ChromaticClaims { balanced: always, ..mixture::claims(channels, &q, &moments) }
    }

    fn capabilities(&self) -> Vec<Capability> {
        vec![Capability::ChannelDensity]
    }

    fn accepts(&self, channels: &[Channel]) -> Result<(), ParameterError> {
        self.probabilities.accepts(channels)?;
        let n = channels.len();
        if let Some(channel) = self.channel {
            let must_be = format!("less than the number of channels, {n}");
            parameter::require(channel < n, "channel", channel, &must_be)?;
        }
        let scatters = |c: &Channel| c.albedo * mixture::sigma(c) > 0.0;
        let transparent = |(channel, q): (&Channel, f64)| q > 0.0 && !(mixture::sigma(channel) > 0.0);
        let missed = channels.iter().zip(self.mixture(n)).position(transparent);
        match missed {
            Some(k) if channels.iter().any(scatters) => {
                let must_be = "one that is not transparent, since others scatter";
                Err(ParameterError::new("channel", k, must_be))
            }
            _ => Ok(()),
        }
    }
}

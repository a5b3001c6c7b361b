use super::block::{self, Heuristic, Own};
use super::mixture::{self, Mixed, Probabilities};
use crate::capability::Capability;
use crate::chromatic::ChromaticSampler;
use crate::claims::{Channel, ChromaticClaims};
use crate::parameter::ParameterError;
use freepath_draws::{Draws, Streams};

/// A distance from one channel drawn at random, weighted by the power heuristic of exponent 2 in the one-sample model
/// (Veach and Guibas 1995).
///
/// ```text
/// w_k = f_k(t) u_i / sum_j u_j^2,   u_j = q_j p_j(t),   channel i drawn
/// p_j = sigma_j exp(-sigma_j t) and f_k = albedo_k p_k scattered;   p_k = f_k = exp(-sigma_k length) at the surface
/// E[w_k^p] = int f_k^p sum_j u_j^(p+1) / (sum_j u_j^2)^p dt
/// ```
///
/// Target: mean albedo_k (1 - T_k) scattered and T_k at the surface, in each channel k.
/// Range:  not negative.
/// Cost:   two uniforms.
/// Needs:  homogeneous channels of one length.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(try_from = "Mixed", into = "Mixed")]
#[schemars(with = "Mixed")]
pub struct Power {
    probabilities: Probabilities,
}

impl Power {
    /// Channels drawn with these probabilities, or all alike.
    ///
    /// # Errors
    /// If one is not positive, or their sum is not 1.
    pub fn new(channel_probabilities: Option<Vec<f64>>) -> Result<Self, ParameterError> {
        Probabilities::positive(channel_probabilities).map(|probabilities| Self { probabilities })
    }

    /// q_k p_k(t).
    #[inline(always)]
    fn share(&self, channels: &[Channel], k: usize, t: f64) -> f64 {
        self.probabilities.of(k, channels.len()) * mixture::density(&channels[k], t)
    }

    /// The sum of `power` of every u_j / scale.
    fn sum(&self, channels: &[Channel], t: f64, scale: f64, power: fn(f64) -> f64) -> f64 {
        let term = |k| power(self.share(channels, k, t) / scale);
        (0..channels.len()).map(term).sum()
    }
}

impl TryFrom<Mixed> for Power {
    type Error = ParameterError;

    fn try_from(fields: Mixed) -> Result<Self, ParameterError> {
        Self::new(fields.channel_probabilities)
    }
}

impl From<Power> for Mixed {
    fn from(sampler: Power) -> Self {
        sampler.probabilities.into()
    }
}

impl Heuristic for Power {
    #[inline(always)]
    fn add(&self, sum: f64, share: f64, own: Own) -> f64 {
        let ratio = share / (own.probability * own.density); // lest small squares vanish
        sum + ratio * ratio
    }

    #[inline(always)]
    fn divisor(&self, sum: f64, own: Own) -> f64 {
        own.probability * own.density * sum
    }
}

impl ChromaticSampler for Power {
    fn sample(&self, channels: &[Channel], rng: &mut dyn rand::Rng, weights: &mut [f64]) -> f64 {
        let drawn = self.probabilities.draw(channels.len(), rng);
        let t = mixture::distance(&channels[drawn], rng);
        let own = self.share(channels, drawn, t);
        let squares = self.sum(channels, t, own, |x| x * x); // over u_i, lest small squares vanish
        for (weight, channel) in weights.iter_mut().zip(channels) {
            *weight = mixture::contribution(channel, t) / own / squares;
        }
        t
    }

    fn sample_block(&self, channels: &[Channel], streams: &Streams, out: &mut Draws) {
        block::draws(self, channels, &self.probabilities.all(channels.len()), streams, out);
    }

    fn pdf(&self, channels: &[Channel], t: f64) -> Option<f64> {
        Some(mixture::pdf(channels, &self.probabilities.all(channels.len()), t))
    }

    fn claims(&self, channels: &[Channel]) -> ChromaticClaims {
        let q = self.probabilities.all(channels.len());
        mixture::claims(channels, &q, &|f, t, order| {
            let scale = mixture::pdf(channels, &q, t);
            let squares = self.sum(channels, t, scale, |x| x * x);
            let drawn = |k| {
                let share = self.share(channels, k, t) / scale;
                share * mixture::even_power(f / scale * share / squares, order)
            };
            scale * (0..channels.len()).map(drawn).sum::<f64>()
        })
    }

    fn capabilities(&self) -> Vec<Capability> {
        vec![Capability::ChannelMixture]
    }

    fn accepts(&self, channels: &[Channel]) -> Result<(), ParameterError> {
        self.probabilities.accepts(channels)
    }
}

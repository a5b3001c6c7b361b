use super::block::{self, Heuristic, Own};
use super::mixture::{self, Mixed, Probabilities};
use crate::capability::Capability;
use crate::chromatic::ChromaticSampler;
use crate::claims::{Channel, ChromaticClaims};
use crate::parameter::ParameterError;
use freepath_draws::{Draws, Streams};

/// A distance from one channel drawn at random, weighted by the balance heuristic over all of them (Veach and Guibas
/// 1995; pbrt-v3).
///
/// ```text
/// w_k = albedo_k sigma_k exp(-sigma_k t) / sum_j q_j sigma_j exp(-sigma_j t),   scattered at t < length
/// w_k = exp(-sigma_k length) / sum_j q_j exp(-sigma_j length),                  at the surface
/// ```
///
/// Target: mean albedo_k (1 - T_k) scattered and T_k at the surface, in each channel k.
/// Range:  w_k <= albedo_k / q_k, and 1 / q_k at the surface.
/// Cost:   two uniforms.
/// Needs:  homogeneous channels of one length.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(try_from = "Mixed", into = "Mixed")]
#[schemars(with = "Mixed")]
pub struct Balance {
    probabilities: Probabilities,
}

impl Balance {
    /// Channels drawn with these probabilities, or all alike.
    ///
    /// # Errors
    /// If one is not positive, or their sum is not 1.
    pub fn new(channel_probabilities: Option<Vec<f64>>) -> Result<Self, ParameterError> {
        Probabilities::positive(channel_probabilities).map(|probabilities| Self { probabilities })
    }
}

impl TryFrom<Mixed> for Balance {
    type Error = ParameterError;

    fn try_from(fields: Mixed) -> Result<Self, ParameterError> {
        Self::new(fields.channel_probabilities)
    }
}

impl From<Balance> for Mixed {
    fn from(sampler: Balance) -> Self {
        sampler.probabilities.into()
    }
}

impl Heuristic for Balance {
    #[inline(always)]
    fn add(&self, sum: f64, share: f64, _own: Own) -> f64 {
        sum + share
    }

    #[inline(always)]
    fn divisor(&self, sum: f64, _own: Own) -> f64 {
        sum
    }
}

impl ChromaticSampler for Balance {
    fn sample(&self, channels: &[Channel], rng: &mut dyn rand::Rng, weights: &mut [f64]) -> f64 {
        let n = channels.len();
        let t = mixture::distance(&channels[self.probabilities.draw(n, rng)], rng);
        let terms = channels.iter().enumerate();
        let pdf: f64 = terms.map(|(k, c)| self.probabilities.of(k, n) * mixture::density(c, t)).sum();
        for (weight, channel) in weights.iter_mut().zip(channels) {
            *weight = mixture::contribution(channel, t) / pdf;
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
        let moments = |f: f64, t: f64, order| {
            let pdf = mixture::pdf(channels, &q, t);
            pdf * mixture::even_power(f / pdf, order)
        };
        ChromaticClaims { balanced: true, ..mixture::claims(channels, &q, &moments) }
    }

    fn capabilities(&self) -> Vec<Capability> {
        vec![Capability::ChannelMixture, Capability::BalanceHeuristic]
    }

    fn accepts(&self, channels: &[Channel]) -> Result<(), ParameterError> {
        self.probabilities.accepts(channels)
    }
}

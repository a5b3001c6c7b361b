use freepath_estimators::ChromaticSampler;
use freepath_estimators::claims::Channel;

/// The channels of a scene and the sampler that draws from them, for faults of its weights.
pub struct ChannelMixture<'a> {
    sampler: &'a dyn ChromaticSampler,
    channels: Vec<Channel<'a>>,
}

impl<'a> ChannelMixture<'a> {
    /// `channels` as `sampler` draws from them.
    #[must_use]
    pub(crate) fn new(sampler: &'a dyn ChromaticSampler, channels: Vec<Channel<'a>>) -> Self {
        Self { sampler, channels }
    }

    /// The channels.
    pub(super) fn channels(&self) -> &[Channel<'a>] {
        &self.channels
    }

    /// The probability of drawing each channel, if the sampler claims it.
    pub(super) fn probabilities(&self) -> Option<Vec<f64>> {
        self.sampler.claims(&self.channels).mixture
    }

    /// The density of the unweighted distance at `t`; NaN if the sampler does not tell it.
    pub(super) fn pdf(&self, t: f64) -> f64 {
        self.sampler.pdf(&self.channels, t).unwrap_or(f64::NAN)
    }

    /// Another draw: the distance, and the weight of each channel.
    pub(super) fn redraw(&self, rng: &mut dyn rand::Rng, weights: &mut [f64]) -> f64 {
        self.sampler.sample(&self.channels, rng, weights)
    }

    /// Extinction of channel `k`, which is homogeneous.
    pub(super) fn mu(&self, k: usize) -> f64 {
        self.channels[k].extinction.mu(0.0)
    }

    /// The density of channel `k` at `t`, or its probability of reaching the end.
    pub(super) fn density(&self, k: usize, t: f64) -> f64 {
        let mu = self.mu(k);
        if t.is_finite() { mu * libm::exp(-mu * t) } else { libm::exp(-mu * self.channels[k].extinction.length()) }
    }
}

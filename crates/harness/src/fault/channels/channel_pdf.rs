use crate::fault::{BlockContext, Injection, SampledChannels, Target};
use freepath_draws::Draws;
use freepath_estimators::claims::Channel;

/// Weights are divided by the density of one channel alone, where that of the mixture is due.
///
/// ```text
/// right: w_k = f_k / sum_j q_j p_j;   wrong: w_k = f_k / p_channel
/// ```
///
/// Shows in: the mean in every channel; nowhere where all channels are alike.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ChannelPdf {
    /// From 0.
    channel: usize,
}

/// The density of a channel at `t`, or its probability of reaching the end.
pub(super) fn density(channel: &Channel, t: f64) -> f64 {
    let mu = channel.extinction.mu(0.0);
    if t.is_finite() { mu * libm::exp(-mu * t) } else { libm::exp(-mu * channel.extinction.length()) }
}

impl Injection for ChannelPdf {
    fn fits(&self, target: &Target) -> Result<(), String> {
        target.is_one_of(&["balance", "power"])?;
        target.has_channel(self.channel)
    }
    fn corrupt_draws(&self, context: &BlockContext, draws: &mut Draws) {
        let Some(SampledChannels { sampler, medium }) = context.drawn.channels else { return };
        let channels = medium.channels();
        let ChannelColumns { t, channels: mut weights } = ChannelColumns::of(draws)?;
        for (row, &mut t) in t.iter_mut().enumerate() {
            let factor = sampler.pdf(&channels, t).unwrap_or(f64::NAN) / density(&channels[self.channel], t);
            weights.iter_mut().for_each(|column| column[row] *= factor);
        }
        Ok(())
    }
}

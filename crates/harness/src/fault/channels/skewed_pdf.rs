use super::channel_pdf::density;
use crate::fault::{BlockContext, Injection, SampledChannels, Target};
use freepath_draws::Draws;
use freepath_estimators::ParameterError;
use freepath_estimators::parameter::positive;

/// The density of one channel is another in the weight than in the sampling (three-gpu-pathtracer, issue 847: a ratio of
/// 0.93).
///
/// ```text
/// right: w_k = f_k / sum_j q_j p_j;   wrong: q_channel p_channel counts `factor` times
/// ```
///
/// Shows in: the mean in every channel; hardly where the channel is seldom drawn.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SkewedPdf {
    /// From 0.
    channel: usize,
    /// What its density is multiplied by.
    factor: f64,
}

impl Injection for SkewedPdf {
    fn check(&self) -> Result<(), ParameterError> {
        positive("factor", self.factor).map(drop)
    }
    fn fits(&self, target: &Target) -> Result<(), String> {
        target.is_one_of(&["balance"])?;
        target.has_channel(self.channel)
    }
    fn corrupt_draws(&self, context: &BlockContext, draws: &mut Draws) {
        let Some(SampledChannels { sampler, medium }) = context.drawn.channels else { return };
        let channels = medium.channels();
        let Some(mixture) = sampler.claims(&channels).mixture else { return Ok(()) };
        let ChannelColumns { t, channels: mut weights } = ChannelColumns::of(draws)?;
        for (row, &mut t) in t.iter_mut().enumerate() {
            let right: f64 = channels.iter().zip(&mixture).map(|(channel, q)| q * density(channel, t)).sum();
            let own = mixture[self.channel] * density(&channels[self.channel], t);
            let factor = right / (right + (self.factor - 1.0) * own);
            weights.iter_mut().for_each(|column| column[row] *= factor);
        }
        Ok(())
    }
}

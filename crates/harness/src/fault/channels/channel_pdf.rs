use crate::fault::{BlockContext, Injection, Target};
use freepath_draws::{ChannelColumns, Draws, MissingColumn};
use freepath_estimators::Capability;

/// Weights are divided by the density of one channel alone, where that of the mixture is due (a typical slip).
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

impl Injection for ChannelPdf {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::ChannelMixture]
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.has_channel(self.channel)
    }
    fn corrupt_draws(&self, context: &BlockContext, draws: &mut Draws) -> Result<(), MissingColumn> {
        let Some(mixture) = &context.mixture else { return Ok(()) };
        let ChannelColumns { t, channels: mut weights } = ChannelColumns::of(draws)?;
        for (row, &mut t) in t.iter_mut().enumerate() {
            let factor = mixture.pdf(t) / mixture.density(self.channel, t);
            weights.iter_mut().for_each(|column| column[row] *= factor);
        }
        Ok(())
    }
}

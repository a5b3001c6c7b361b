use crate::fault::{BlockContext, Injection, Target};
use freepath_draws::{ChannelColumns, Draws, MissingColumn};
use freepath_estimators::parameter::positive;
use freepath_estimators::{Capability, ParameterError};

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
    /// The factor that multiplies its density.
    factor: f64,
}

impl Injection for SkewedPdf {
    fn check(&self) -> Result<(), ParameterError> {
        positive("factor", self.factor).map(drop)
    }
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::BalanceHeuristic]
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.has_channel(self.channel)
    }
    fn corrupt_draws(&self, context: &BlockContext, draws: &mut Draws) -> Result<(), MissingColumn> {
        let Some(mixture) = &context.mixture else { return Ok(()) };
        let Some(probabilities) = mixture.probabilities() else { return Ok(()) };
        let ChannelColumns { t, channels: mut weights } = ChannelColumns::of(draws)?;
        for (row, &mut t) in t.iter_mut().enumerate() {
            let right: f64 = probabilities.iter().enumerate().map(|(k, q)| q * mixture.density(k, t)).sum();
            let own = probabilities[self.channel] * mixture.density(self.channel, t);
            let factor = right / (right + (self.factor - 1.0) * own);
            weights.iter_mut().for_each(|column| column[row] *= factor);
        }
        Ok(())
    }
}

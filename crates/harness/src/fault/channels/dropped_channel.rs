use crate::fault::{BlockContext, Injection, SampledChannels, Target};
use freepath_draws::Draws;

/// A transparent channel is never drawn, and what it should carry is left to the rare escapes of the others (Cycles, commit
/// 2276a98f8).
///
/// ```text
/// right: q_k > 0 where mu_k = 0, and that channel always escapes;   wrong: q_k = 0
/// ```
///
/// Draws of that channel are drawn again.
///
/// Shows in: the law of the unweighted distance; a test of the mean sees draws of 0 and no variance.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DroppedChannel {
    /// From 0: transparent.
    channel: usize,
}

/// Draws are not drawn again for ever if another channel is drawn so often,
const RARELY: f64 = 1e-3;
/// and is so dense that 1 / T exceeds 1 by more than rounding.
const THIN: f64 = 1e-9;

impl DroppedChannel {
    /// Whether drawing again comes to an end.
    fn ends(&self, target: &Target) -> bool {
        let Some(medium) = target.channels else { return true };
        let probability = |k: usize| target.parameters["channel_probabilities"][k].as_f64();
        let dense = |k: usize| medium.channels()[k].extinction.mu(0.0) * medium.length() >= THIN;
        let often = |k: usize| probability(k).is_none_or(|q| q >= RARELY);
        (0..medium.media().len()).any(|k| k != self.channel && often(k) && dense(k))
    }
}

impl Injection for DroppedChannel {
    fn fits(&self, target: &Target) -> Result<(), String> {
        target.is_one_of(&["single_channel"])?;
        target.has_channel(self.channel)?;
        let drawn = target.parameters["channel_probabilities"][self.channel].as_f64();
        if target.parameters["channel"].is_u64() || drawn.is_some_and(|q| q >= 1.0) {
            return Err("it needs other channels that are drawn".into());
        }
        if !self.ends(target) {
            let needed = format!("drawn at {RARELY} or more, of an optical depth of {THIN} or more");
            return Err(format!("it needs another channel to draw again from, {needed}"));
        }
        let clear =
            target.channels.is_some_and(|medium| medium.channels()[self.channel].extinction.mu(0.0) <= 0.0);
        if clear { Ok(()) } else { Err(format!("channel {} must be transparent", self.channel)) }
    }
    fn corrupt_draws(&self, context: &BlockContext, draws: &mut Draws) {
        let Some(SampledChannels { sampler, medium }) = context.drawn.channels else { return };
        let (channels, mut rng) = (medium.channels(), context.rng());
        let mut weights: Vec<f64> = vec![0.0; channels.len()];
        let mut columns = ChannelColumns::of(draws)?;
        for row in 0..columns.t.len() {
            weights.iter_mut().zip(&columns.channels).for_each(|(weight, column)| *weight = column[row]);
            let mut t = columns.t[row];
            // the channel's own escapes weigh 1 in it, those of others 1 / T_c
            while t == f64::INFINITY && weights[self.channel] <= 1.0 {
                t = sampler.sample(&channels, &mut rng, &mut weights);
            }
            columns.put(row, t, &weights);
        }
        Ok(())
    }
}

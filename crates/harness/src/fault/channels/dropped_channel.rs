use crate::fault::{BlockContext, ChannelMixture, Injection, Target};
use freepath_draws::{ChannelColumns, Draws, MissingColumn};
use freepath_estimators::Capability;

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
    /// True if drawing again comes to an end, if channels have these probabilities.
    fn ends(&self, mixture: &ChannelMixture, probabilities: &[f64]) -> bool {
        let dense = |k: usize| mixture.mu(k) * mixture.channels()[k].extinction.length() >= THIN;
        let mut drawn = probabilities.iter().enumerate();
        drawn.any(|(k, &q)| k != self.channel && q >= RARELY && dense(k))
    }
}

impl Injection for DroppedChannel {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::ChannelDensity]
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.has_channel(self.channel)?;
        let Some(mixture) = &target.mixture else { return Ok(()) };
        let Some(probabilities) = mixture.probabilities() else {
            return Err("it needs a sampler that claims how likely each channel is drawn".into());
        };
        let drawn = probabilities[self.channel];
        if !(drawn > 0.0 && drawn < 1.0) {
            return Err("it needs a channel that is drawn, and others that are drawn, too".into());
        }
        if !self.ends(mixture, &probabilities) {
            let needed = format!("drawn at {RARELY} or more, of an optical depth of {THIN} or more");
            return Err(format!("it needs another channel to draw again from, {needed}"));
        }
        let clear = mixture.mu(self.channel) <= 0.0;
        if clear { Ok(()) } else { Err(format!("channel {} must be transparent", self.channel)) }
    }
    fn corrupt_draws(&self, context: &BlockContext, draws: &mut Draws) -> Result<(), MissingColumn> {
        let Some(mixture) = &context.mixture else { return Ok(()) };
        let mut rng = context.rng();
        let mut weights: Vec<f64> = vec![0.0; mixture.channels().len()];
        let mut columns = ChannelColumns::of(draws)?;
        for row in 0..columns.t.len() {
            weights.iter_mut().zip(&columns.channels).for_each(|(weight, column)| *weight = column[row]);
            let mut t = columns.t[row];
            // the channel's own escapes weigh 1 in it, those of others 1 / T_c
            while t == f64::INFINITY && weights[self.channel] <= 1.0 {
                t = mixture.redraw(&mut rng, &mut weights);
            }
            columns.put(row, t, &weights);
        }
        Ok(())
    }
}

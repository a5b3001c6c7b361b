use super::{BlockPlace, Layer, Plant, Target};
use freepath_estimators::Draws;

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

impl Plant for DroppedChannel {
    fn layer(&self) -> Layer {
        Layer::Draws
    }
    fn fits(&self, target: &Target) -> Result<(), String> {
        target.is_one_of(&["single_channel"])?;
        target.has_channel(self.channel)?;
        let drawn = target.parameters["channel_probabilities"][self.channel].as_f64();
        if target.parameters["channel"].is_u64() || drawn.is_some_and(|q| q >= 1.0) {
            return Err("it needs other channels that are drawn".into());
        }
        let clear = target.channels.is_some_and(|medium| medium.channels()[self.channel].extinction.mu(0.0) <= 0.0);
        if clear { Ok(()) } else { Err(format!("channel {} must be transparent", self.channel)) }
    }
    fn spoil(&self, at: &BlockPlace, draws: &mut Draws) {
        let Some((sampler, medium)) = at.chromatic() else { return };
        let (channels, mut rng) = (medium.channels(), at.rng());
        let mut weights: Vec<f64> = vec![0.0; channels.len()];
        for row in 0..draws.rows {
            weights.iter_mut().zip(&draws.channels).for_each(|(weight, column)| *weight = column[row]);
            let mut t = draws.t[row];
            // the channel's own escapes weigh 1 in it, those of others 1 / T_c
            while t == f64::INFINITY && weights[self.channel] <= 1.0 {
                t = sampler.sample(&channels, &mut rng, &mut weights);
            }
            draws.put(row, t, 1.0, 0);
            draws.channels.iter_mut().zip(&weights).for_each(|(column, weight)| column[row] = *weight);
        }
    }
}

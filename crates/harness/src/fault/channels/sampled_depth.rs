use crate::fault::{BlockContext, Injection, SampledChannels, Target};
use freepath_draws::Draws;
use freepath_draws::random::{exponential, uniform};
use freepath_draws::{ChannelColumns, Draws, MissingColumn};

/// Escapes are weighed at the sampled optical depth instead of the medium's (Tungsten, commit 3907542).
///
/// ```text
/// right: w_k = T_k / sum_c q_c T_c;   wrong: w_k = e_k / sum_c q_c e_c, e_k = exp(-mu_k s), s the sampled distance
/// ```
///
/// The distance beyond the end is drawn again here from its law given the escape.
///
/// Shows in: the mean of the surface in each channel; nowhere where all channels are alike.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SampledDepth {}

impl Injection for SampledDepth {
    fn fits(&self, target: &Target) -> Result<(), String> {
        target.is_one_of(&["balance"])
    }
    fn corrupt_draws(&self, context: &BlockContext, draws: &mut Draws) {
        let Some(SampledChannels { sampler, medium }) = context.drawn.channels else { return };
        let channels = medium.channels();
        let Some(mixture) = sampler.claims(&channels).mixture else { return Ok(()) };
        let (length, mut rng) = (medium.length(), context.rng());
        let mu: Vec<f64> = channels.iter().map(|channel| channel.extinction.mu(0.0)).collect();
        let mean = |s: f64| mixture.iter().zip(&mu).map(|(q, mu)| q * libm::exp(-mu * s)).sum::<f64>();
        let ChannelColumns { t, channels: mut weights } = ChannelColumns::of(draws)?;
        for row in (0..t.len()).filter(|&row| t[row] == f64::INFINITY) {
            let mut left = uniform(&mut rng) * mean(length);
            let drawn = mixture.iter().zip(&mu).position(|(q, mu)| {
                left -= q * libm::exp(-mu * length);
                left < 0.0
            });
            let s = length + exponential(&mut rng) / mu[drawn.unwrap_or(mu.len() - 1)];
            for (column, mu) in weights.iter_mut().zip(&mu) {
                column[row] = libm::exp(-mu * s) / mean(s);
            }
        }
        Ok(())
    }
}

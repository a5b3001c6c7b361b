use crate::fault::{BlockContext, Injection};
use freepath_draws::random::{exponential, uniform};
use freepath_draws::{ChannelColumns, Draws, MissingColumn};
use freepath_estimators::Capability;

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
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::BalanceHeuristic]
    }
    fn corrupt_draws(&self, context: &BlockContext, draws: &mut Draws) -> Result<(), MissingColumn> {
        let Some(mixture) = &context.mixture else { return Ok(()) };
        let Some(probabilities) = mixture.probabilities() else { return Ok(()) };
        let (length, mut rng) = (context.length, context.rng());
        let mu: Vec<f64> = (0..mixture.channels().len()).map(|k| mixture.mu(k)).collect();
        let mean = |s: f64| probabilities.iter().zip(&mu).map(|(q, mu)| q * libm::exp(-mu * s)).sum::<f64>();
        let ChannelColumns { t, channels: mut weights } = ChannelColumns::of(draws)?;
        for row in (0..t.len()).filter(|&row| t[row] == f64::INFINITY) {
            let mut left = uniform(&mut rng) * mean(length);
            let drawn = probabilities.iter().zip(&mu).position(|(q, mu)| {
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

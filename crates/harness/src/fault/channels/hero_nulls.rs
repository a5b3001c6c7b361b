use crate::fault::{BlockContext, Injection, SampledChannels, Target};
use freepath_draws::Draws;

/// Null collisions are chosen by the sampling channel's probability alone (Mitsuba 3, issues 1387 and 1628).
///
/// ```text
/// right: p_null = mean over channels of 1 - mu_k / mu_bar;   wrong: p_null = 1 - mu_c / mu_bar
/// ```
///
/// The densest channel, mu_c = mu_bar, then has no null collision at all, and its escapes weigh 1 in each channel: this is
/// laid over the draws of `single_channel`, whose escapes by channel c weigh T_k / T_c.
///
/// Shows in: the mean of the surface in the other channels; nowhere where all channels are alike.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HeroNulls {}

impl Injection for HeroNulls {
    fn fits(&self, target: &Target) -> Result<(), String> {
        target.is_one_of(&["single_channel"])
    }
    fn corrupt_draws(&self, context: &BlockContext, draws: &mut Draws) {
        let Some(SampledChannels { medium, .. }) = context.drawn.channels else { return };
        let channels = medium.channels();
        let mu = |k: usize| channels[k].extinction.mu(0.0);
        let densest = (0..channels.len()).fold(0, |most, k| if mu(k) > mu(most) { k } else { most });
        let ChannelColumns { t, channels: mut weights } = ChannelColumns::of(draws)?;
        for row in (0..t.len()).filter(|&row| t[row] == f64::INFINITY) {
            // only its own escapes weigh 1 in the densest channel: those of others weigh T_densest / T_c
            if weights[densest][row] > 1.0 - 1e-12 {
                weights.iter_mut().for_each(|column| column[row] = 1.0);
            }
        }
        Ok(())
    }
}

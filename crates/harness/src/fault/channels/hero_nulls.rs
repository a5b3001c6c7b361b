use crate::fault::{BlockContext, Injection};
use freepath_draws::{ChannelColumns, Draws, MissingColumn};
use freepath_estimators::Capability;

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
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::ChannelDensity]
    }
    fn corrupt_draws(&self, context: &BlockContext, draws: &mut Draws) -> Result<(), MissingColumn> {
        let Some(mixture) = &context.mixture else { return Ok(()) };
        let denser = |most, k| if mixture.mu(k) > mixture.mu(most) { k } else { most };
        let densest = (0..mixture.channels().len()).fold(0, denser);
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

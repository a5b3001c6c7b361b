use crate::fault::{BlockContext, Injection};
use freepath_draws::{ChannelColumns, Draws, MissingColumn};
use freepath_estimators::ParameterError;
use freepath_estimators::parameter::require;

/// The weights of a draw are handed to the next one of its bin, as where a wavefront is sorted by bins of distance and not all of its arrays are
/// (a typical slip).
///
/// ```text
/// right: (t, w);   wrong: (t, w of the draw before it in the same bin of the ray), among the draws of a block
/// ```
///
/// Shows in: the law of t under the weights, within bins; nowhere where a weight hardly changes over a bin, and in no mean over whole bins.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ExchangedWeights {
    /// Bins along the ray.
    bins: usize,
}

impl ExchangedWeights {
    /// The rows that scatter, bin by bin.
    fn rows(&self, t: &[f64], length: f64) -> Vec<Vec<usize>> {
        let mut rows = vec![Vec::new(); self.bins];
        for (row, t) in t.iter().enumerate().filter(|(_, t)| t.is_finite()) {
            if let Some(bin) = rows.get_mut((t / length * self.bins as f64) as usize) {
                bin.push(row);
            }
        }
        rows
    }
}

impl Injection for ExchangedWeights {
    fn check(&self) -> Result<(), ParameterError> {
        require((1..=65_536).contains(&self.bins), "bins", self.bins, "1 to 65536").map(drop)
    }
    fn corrupt_draws(&self, context: &BlockContext, draws: &mut Draws) -> Result<(), MissingColumn> {
        let ChannelColumns { t, channels: mut weights } = ChannelColumns::of(draws)?;
        for rows in self.rows(t, context.length) {
            for column in &mut weights {
                let mut before = rows.last().map_or(f64::NAN, |&last| column[last]);
                rows.iter().for_each(|&row| std::mem::swap(&mut column[row], &mut before));
            }
        }
        Ok(())
    }
}

use super::{Claim, Summary, Withdrawal};
use freepath_results::{ClaimResult, MeanResult, Measured, PanelSeries, Real};

/// What formulas say of a scene place by place, to be read beside the claims: it is not tested.
pub struct Remark {
    /// Its name.
    pub name: &'static str,
    /// What it says.
    pub words: String,
    /// What it draws.
    pub panels: Vec<Panel>,
}

/// A panel, and what of the draws belongs into it.
pub struct Panel {
    /// What formulas say.
    pub series: PanelSeries,
    /// The place that the draws tell of.
    pub place: Option<usize>,
    /// What they tell.
    pub shows: Shows,
}

/// A number of the draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shows {
    /// Their mean, with its interval.
    Mean,
    /// Their variance.
    Variance,
}

impl Claim for Remark {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new(self.name, self.words.clone()))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth]
    }

    fn state(&self, into: &mut Summary) {
        into.series.panels.extend(self.panels.iter().map(|panel| panel.series.clone()));
    }

    /// Claims summarize in their order: the mean stands in the results before.
    fn summarize(&self, _: &crate::fold::Tallies, into: &mut Summary) {
        let Some(mean) = into.mean.as_ref() else { return };
        let measured: Vec<_> = self.panels.iter().map(|panel| panel.measured(mean)).collect();
        let first = into.series.panels.len() - self.panels.len();
        for (series, measured) in into.series.panels[first..].iter_mut().zip(measured) {
            series.measured = measured;
        }
    }
}

impl Panel {
    fn measured(&self, mean: &MeanResult) -> Option<Measured> {
        let place = self.place?;
        Some(match self.shows {
            Shows::Mean => {
                let end = |bias: Real| Real(mean.expected.0 + bias.0);
                Measured { place, value: mean.estimate, low: end(mean.low), high: end(mean.high) }
            }
            Shows::Variance => Measured { place, value: mean.variance, low: mean.variance, high: mean.variance },
        })
    }
}

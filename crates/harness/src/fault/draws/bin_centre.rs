use crate::fault::{BlockContext, Injection, Target};
use freepath_draws::{Draws, MissingColumn, column};
use freepath_estimators::ParameterError;
use freepath_estimators::parameter::require;

/// A collision is put at the middle of its bin, as by a histogram that is sampled without a second number (a typical slip).
///
/// ```text
/// right: t;   wrong: (floor(t / width) + 1/2) width,   width = length / bins
/// ```
///
/// Shows in: the law of t, weighted or not, within bins; in no share of a whole bin, and nowhere where bins are narrow.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BinCentre {
    /// Bins along the ray.
    bins: u64,
}

/// Most bins: their numbers are exact.
const MOST: u64 = 1 << 52;

impl Injection for BinCentre {
    fn check(&self) -> Result<(), ParameterError> {
        require((1..=MOST).contains(&self.bins), "bins", self.bins, "1 to 2^52").map(drop)
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.draws_distances_or_channels()
    }
    fn corrupt_draws(&self, context: &BlockContext, draws: &mut Draws) -> Result<(), MissingColumn> {
        let width = context.length / self.bins as f64;
        for t in draws.f64_mut(column::T)?.iter_mut().filter(|t| t.is_finite()) {
            *t = ((*t / width).floor() + 0.5) * width;
        }
        Ok(())
    }
}

use crate::fault::{BlockContext, Injection, Target};
use freepath_draws::random::uniform;
use freepath_draws::{Draws, MissingColumn, column};
use freepath_estimators::ParameterError;
use freepath_estimators::parameter::require;

/// Where a table of inverses has no answer, one of its bins is taken (a typical slip).
///
/// ```text
/// right: t;   wrong: of a collision anywhere within `width` of the ray behind `at`, with probability `share`
/// ```
///
/// Shows in: counts in one fine cell; nowhere if the share is small enough for the draws.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HotSpot {
    /// Where the bin begins, as a share of the ray.
    at: f64,
    /// Its width, as a share of the ray.
    width: f64,
    /// The share of the draws.
    share: f64,
}

impl Injection for HotSpot {
    fn check(&self) -> Result<(), ParameterError> {
        let share = |name, x: f64| require(x > 0.0 && x < 1.0, name, x, "between 0 and 1").map(drop);
        share("at", self.at)?;
        share("width", self.width)?;
        share("share", self.share)?;
        require(self.at + self.width <= 1.0, "width", self.width, "no further than the end of the ray").map(drop)
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.draws_distances()
    }
    fn corrupt_draws(&self, context: &BlockContext, draws: &mut Draws) -> Result<(), MissingColumn> {
        let mut rng = context.rng();
        for t in draws.f64_mut(column::T)?.iter_mut().filter(|t| t.is_finite()) {
            if uniform(&mut rng) < self.share {
                *t = context.length * (self.at + self.width * uniform(&mut rng));
            }
        }
        Ok(())
    }
}

use crate::fault::{BlockContext, Injection};
use freepath_draws::Draws;
use freepath_draws::random::uniform;
use freepath_estimators::ParameterError;
use freepath_estimators::parameter::require;

/// Now and then a draw repeats the one before it: a generator that is read twice.
///
/// ```text
/// right: a fresh draw;   wrong: the draw before, with probability `share`
/// ```
///
/// Shows in: ties and the order of the draws; each draw alone is right.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DuplicatedDraws {
    /// The share of repeats.
    share: f64,
}

impl Injection for DuplicatedDraws {
    fn check(&self) -> Result<(), ParameterError> {
        require(self.share > 0.0 && self.share < 1.0, "share", self.share, "between 0 and 1").map(drop)
    }
    fn corrupt_draws(&self, context: &BlockContext, draws: &mut Draws) {
        let mut rng = context.rng();
        for row in 1..draws.rows {
            if uniform(&mut rng) < self.share {
                for column in [&mut draws.t, &mut draws.weight].into_iter().chain(&mut draws.channels) {
                    if !column.is_empty() {
                        column[row] = column[row - 1];
                    }
                }
            }
        }
    }
}

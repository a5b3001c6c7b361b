use crate::fault::{BlockContext, Injection};
use freepath_draws::random::uniform;
use freepath_draws::{Draws, MissingColumn, NumbersMut};
use freepath_estimators::ParameterError;
use freepath_estimators::parameter::require;

/// Now and then a draw repeats the one before it: a generator that is read twice (a typical slip).
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
    fn corrupt_draws(&self, context: &BlockContext, draws: &mut Draws) -> Result<(), MissingColumn> {
        let mut rng = context.rng();
        let rows = draws.rows();
        let mut columns: Vec<&mut [f64]> = numbers(draws).collect();
        for row in 1..rows {
            if uniform(&mut rng) < self.share {
                columns.iter_mut().for_each(|column| column[row] = column[row - 1]);
            }
        }
        Ok(())
    }
}

/// All columns but counts.
fn numbers(draws: &mut Draws) -> impl Iterator<Item = &mut [f64]> {
    draws.columns_mut().filter_map(|(_, numbers)| match numbers {
        NumbersMut::F64(numbers) => Some(numbers),
        NumbersMut::U32(_) => None,
    })
}

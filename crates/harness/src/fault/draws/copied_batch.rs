use crate::fault::{BlockContext, Injection};
use freepath_draws::{Draws, MissingColumn, NumbersMut};
use freepath_estimators::ParameterError;
use freepath_estimators::parameter::require;

/// A batch of draws is handed out again and again: a buffer that is not filled anew (a typical slip).
///
/// ```text
/// right: fresh draws;   wrong: draw i is draw i mod `draws` of its block
/// ```
///
/// Shows in: the order of the draws at long range, in estimates as in distances; each draw alone is right, error bars are too small.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CopiedBatch {
    /// Draws of the batch. A block has 16,384.
    draws: u64,
}

impl Injection for CopiedBatch {
    fn check(&self) -> Result<(), ParameterError> {
        require(self.draws >= 1, "draws", self.draws, "at least 1").map(drop)
    }
    fn corrupt_draws(&self, _context: &BlockContext, draws: &mut Draws) -> Result<(), MissingColumn> {
        let batch = self.draws as usize;
        for (_, numbers) in draws.columns_mut() {
            match numbers {
                NumbersMut::F64(numbers) => {
                    (batch..numbers.len()).for_each(|row| numbers[row] = numbers[row - batch])
                }
                NumbersMut::U32(numbers) => {
                    (batch..numbers.len()).for_each(|row| numbers[row] = numbers[row - batch])
                }
            }
        }
        Ok(())
    }
}

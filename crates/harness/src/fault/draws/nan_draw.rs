use crate::fault::{BlockContext, Injection};
use freepath_draws::{Draws, MissingColumn, NumbersMut};
use freepath_estimators::ParameterError;
use freepath_estimators::parameter::require;

/// One walk of so many gives NaN: 0 / 0 in a rare branch (a typical slip).
///
/// ```text
/// right: a finite draw;   wrong: NaN, and a statistic that skips it
/// ```
///
/// Shows in: the count of draws that are not finite.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NanDraw {
    /// The walk that becomes NaN, from 0.
    walk: u64,
    /// Of how many.
    of: u64,
}

impl Injection for NanDraw {
    fn check(&self) -> Result<(), ParameterError> {
        require(self.walk < self.of, "walk", self.walk, "less than `of`").map(drop)
    }
    fn corrupt_draws(&self, context: &BlockContext, draws: &mut Draws) -> Result<(), MissingColumn> {
        for row in 0..draws.rows() {
            if (context.first + row as u64) % self.of == self.walk {
                draws.columns_mut().for_each(|(_, numbers)| match numbers {
                    NumbersMut::F64(numbers) => numbers[row] = f64::NAN,
                    NumbersMut::U32(counts) => counts[row] = 0,
                });
            }
        }
        Ok(())
    }
}

use crate::fault::{BlockContext, Injection};
use freepath_draws::Draws;
use freepath_estimators::ParameterError;
use freepath_estimators::parameter::require;

/// One walk of so many gives NaN: 0 / 0 in a rare branch.
///
/// ```text
/// right: a finite draw;   wrong: NaN, and a statistic that skips it
/// ```
///
/// Shows in: the count of draws that are not finite.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NanDraw {
    /// Which, from 0.
    walk: u64,
    /// Of how many.
    of: u64,
}

impl Injection for NanDraw {
    fn check(&self) -> Result<(), ParameterError> {
        require(self.walk < self.of, "walk", self.walk, "less than `of`").map(drop)
    }
    fn corrupt_draws(&self, context: &BlockContext, draws: &mut Draws) {
        for row in 0..draws.rows {
            if (context.first + row as u64) % self.of == self.walk {
                draws.put(row, f64::NAN, f64::NAN, 0);
                draws.channels.iter_mut().for_each(|column| column[row] = f64::NAN);
            }
        }
    }
}

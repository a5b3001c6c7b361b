use crate::fault::{BlockContext, Injection, Target};
use freepath_draws::{Draws, MissingColumn, column};
use freepath_estimators::Capability;

/// The record of a history that ended with weight 0 is not reset, and leaks into the next (MCX, issue 222; pbrt-v4, commit
/// 4ba4b4b1).
///
/// ```text
/// right: n := 0 at every start;   wrong: n := 0 only if the draw before ended with w > 0
/// ```
///
/// Shows in: the law of the collision count; the weights alone are right, and so is all where no weight is 0.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LeakedRecord {}

impl Injection for LeakedRecord {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::Collisions]
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.draws_estimates()
    }
    fn corrupt_draws(&self, _context: &BlockContext, draws: &mut Draws) -> Result<(), MissingColumn> {
        let weight = draws.f64(column::WEIGHT)?.to_vec();
        let collisions = draws.u32_mut(column::COLLISIONS)?;
        for row in 1..weight.len() {
            if weight[row - 1] == 0.0 {
                collisions[row] += collisions[row - 1];
            }
        }
        Ok(())
    }
}

use crate::fault::{BlockContext, Injection, Target};
use freepath_draws::Draws;
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
    fn corrupt_draws(&self, _context: &BlockContext, draws: &mut Draws) {
        for row in 1..draws.rows {
            if draws.weight[row - 1] == 0.0 {
                draws.collisions[row] += draws.collisions[row - 1];
            }
        }
    }
}

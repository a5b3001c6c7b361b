use crate::fault::{BlockContext, Injection};
use freepath_draws::{Draws, MissingColumn, NumbersMut, column};
use freepath_estimators::parameter::require;
use freepath_estimators::{Capability, ParameterError};

/// Draws are handed out in the order in which walks end, not in the order in which they start: short walks come first (a
/// typical slip).
///
/// ```text
/// right: row i is the i-th draw started;   wrong: the i-th of its window that ends
/// ```
///
/// Shows in: the order of the draws, and in any run that stops at a count of them.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompletionOrder {
    /// Walks in flight at a time.
    window: usize,
}

impl Injection for CompletionOrder {
    fn check(&self) -> Result<(), ParameterError> {
        require((2..=16_384).contains(&self.window), "window", self.window, "2 to 16384").map(drop)
    }
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::Collisions]
    }
    fn corrupt_draws(&self, _context: &BlockContext, draws: &mut Draws) -> Result<(), MissingColumn> {
        let collisions = draws.u32(column::COLLISIONS)?.to_vec();
        let rows: Vec<usize> = (0..draws.rows()).collect();
        for part in rows.chunks(self.window) {
            let mut order = part.to_vec();
            order.sort_by_key(|&row| collisions[row]);
            for (_, numbers) in draws.columns_mut() {
                match numbers {
                    NumbersMut::F64(numbers) => permute(numbers, part, &order),
                    NumbersMut::U32(counts) => permute(counts, part, &order),
                }
            }
        }
        Ok(())
    }
}

fn permute<T: Copy>(column: &mut [T], to: &[usize], from: &[usize]) {
    let moved: Vec<T> = from.iter().map(|&row| column[row]).collect();
    for (&row, value) in to.iter().zip(moved) {
        column[row] = value;
    }
}

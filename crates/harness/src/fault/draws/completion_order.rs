use crate::fault::{BlockContext, Injection};
use freepath_draws::Draws;
use freepath_estimators::parameter::require;
use freepath_estimators::{Capability, ParameterError};

/// Draws are handed out in the order in which walks end, not in the order in which they start: short walks come first.
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
    fn corrupt_draws(&self, _context: &BlockContext, draws: &mut Draws) {
        let rows: Vec<usize> = (0..draws.rows).collect();
        for part in rows.chunks(self.window) {
            let mut order = part.to_vec();
            order.sort_by_key(|&row| draws.collisions.get(row).copied().unwrap_or(0));
            permute(&mut draws.t, part, &order);
            permute(&mut draws.weight, part, &order);
            permute(&mut draws.mark, part, &order);
            permute(&mut draws.collisions, part, &order);
        }
    }
}

fn permute<T: Copy>(column: &mut [T], to: &[usize], from: &[usize]) {
    if column.is_empty() {
        return;
    }
    let moved: Vec<T> = from.iter().map(|&row| column[row]).collect();
    for (&row, value) in to.iter().zip(moved) {
        column[row] = value;
    }
}

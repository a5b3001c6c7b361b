use crate::fault::cells::around;
use crate::fault::walk_progress::depth_of;
use crate::fault::{Injection, Overlay, Target, WalkContext};
use freepath_estimators::{Capability, Extinction};
use std::cell::Cell;

/// The optical depth left over is not reduced at the end of a cell (a typical slip).
///
/// ```text
/// right: depth -= mu_i h_i;   wrong: the whole depth is held against each cell
/// seen:  mu_i where depth < mu_i h_i, else 0
/// ```
///
/// Shows in: the law of t and the escape atom; nowhere where there is one cell.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LeftoverDepth {}

struct Leftover<'a> {
    medium: &'a dyn Extinction,
    depth: Cell<f64>,
}

impl Overlay for Leftover<'_> {
    fn word(&self, stream: &mut dyn FnMut() -> u64) -> u64 {
        let word = stream();
        self.depth.set(depth_of(word));
        word
    }
    fn answer(&self, t: f64, mu: f64) -> f64 {
        let [(start, end), _] = around(self.medium.breaks(), self.medium.length(), t);
        if self.depth.get() < mu * (end - start) { mu } else { 0.0 }
    }
}

impl Injection for LeftoverDepth {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::ConstantCells]
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.has_constant_cells()
    }
    fn overlay<'a>(&'a self, context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Leftover { medium: context.medium, depth: Cell::default() }))
    }
}

use crate::fault::cells::around;
use crate::fault::{Injection, Overlay, Target, WalkContext};
use freepath_estimators::{Capability, Extinction};

/// A step through a cell is charged with the extinction of the next one (Celeritas, issue 363).
///
/// ```text
/// right: tau_left -= mu_i dt_i;   wrong: tau_left -= mu_(i+1) dt_i
/// ```
///
/// Shows in: the law of t and the escape atom; nowhere where neighbours are equal.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NextCell {}

/// Looks up in the middle of the next cell.
pub(super) struct Next<'a>(pub(super) &'a dyn Extinction);

impl Overlay for Next<'_> {
    fn place(&self, t: f64) -> f64 {
        let [_, (start, end)] = around(self.0.breaks(), self.0.length(), t);
        0.5 * (start + end)
    }
}

impl Injection for NextCell {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::LookUps]
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.has_constant_cells()
    }
    fn overlay<'a>(&'a self, context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Next(context.medium)))
    }
}

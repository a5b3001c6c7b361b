use crate::fault::{Injection, Overlay, WalkContext};
use freepath_estimators::Capability;
use std::cell::Cell;

/// The collision test uses mu at the position before the step (a typical slip).
///
/// ```text
/// right: t += dt; real if u < mu(t) / mu_bar;   wrong: real if u < mu(t - dt) / mu_bar
/// ```
///
/// Shows in: the law of t and the mean; nowhere where mu is constant.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StalePosition {}

/// The place of the look-up before.
#[derive(Default)]
struct Last(Cell<f64>);

impl Overlay for Last {
    fn begin(&self) {
        self.0.set(0.0);
    }
    fn place(&self, t: f64) -> f64 {
        self.0.replace(t)
    }
}

impl Injection for StalePosition {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::LookUps]
    }
    fn overlay<'a>(&'a self, _context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Last::default()))
    }
}

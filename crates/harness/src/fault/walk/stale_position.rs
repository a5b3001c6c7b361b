use crate::fault::{Injection, Overlay, Target, WalkContext};
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
    fn fits(&self, target: &Target) -> Result<(), String> {
        target.looks_up()
    }
    fn overlay<'a>(&'a self, _context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Last::default()))
    }
}

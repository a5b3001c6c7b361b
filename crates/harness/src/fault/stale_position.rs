use super::overlay::{Overlay, Site};
use super::{Layer, Plant, Target};
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

impl Plant for StalePosition {
    fn layer(&self) -> Layer {
        Layer::Walk
    }
    fn fits(&self, target: &Target) -> Result<(), String> {
        target.looks_up()
    }
    fn lay<'a>(&'a self, _site: Site<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Last::default()))
    }
}

use crate::fault::block_context::FAULT_LANE;
use crate::fault::{Injection, Overlay, WalkContext};
use freepath_draws::random::uniform;
use freepath_estimators::{Capability, Extinction, FreePath};
use std::cell::{Cell, RefCell};

/// Ratio tracking that kills as well as weighs (OpenVKL, commit b3525463).
///
/// ```text
/// right: w *= 1 - mu / mu_bar, or w = 0 with probability mu / mu_bar;   wrong: both
/// mean:  exp(-int (2 mu - mu^2 / mu_bar))
/// ```
///
/// Shows in: the mean; nowhere where every weight is 0 already, as under a tight majorant in a homogeneous medium.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct KillingRatio {}

struct Killing<'a> {
    medium: &'a dyn Extinction,
    rng: RefCell<Box<dyn rand::Rng>>,
    killed: Cell<bool>,
}

impl Overlay for Killing<'_> {
    fn begin(&self) {
        self.killed.set(false);
    }
    fn answer(&self, t: f64, mu: f64) -> f64 {
        if uniform(&mut **self.rng.borrow_mut()) * self.medium.majorants().mu_bar_at(t) < mu {
            self.killed.set(true);
        }
        mu
    }
    fn finish(&self, path: FreePath) -> Option<FreePath> {
        Some(if self.killed.get() { FreePath { weight: 0.0, ..path } } else { path })
    }
}

impl Injection for KillingRatio {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::RatioWeight]
    }
    fn overlay<'a>(&'a self, context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        let rng = RefCell::new(Box::new(context.key.lane(FAULT_LANE)));
        Some(Box::new(Killing { medium: context.medium, rng, killed: Cell::default() }))
    }
}

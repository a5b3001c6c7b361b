use crate::fault::{Injection, Overlay, WalkContext};
use freepath_estimators::{Capability, Extinction, FreePath};
use std::cell::Cell;

/// A roulette survives with the weight itself as probability, so that every negative weight dies (Tungsten, commit 96303fb).
///
/// ```text
/// right: p = min(1, |w| / w_0);   wrong: p = min(1, w / w_0)
/// ```
///
/// Shows in: the mean where weights can be negative; nowhere under a majorant that bounds.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SignedRoulette {}

struct Signed<'a> {
    medium: &'a dyn Extinction,
    killed: Cell<bool>,
}

impl Overlay for Signed<'_> {
    fn begin(&self) {
        self.killed.set(false);
    }
    fn answer(&self, t: f64, mu: f64) -> f64 {
        if mu > self.medium.majorants().mu_bar_at(t) {
            self.killed.set(true); // its weight turns negative here
        }
        mu
    }
    fn finish(&self, path: FreePath) -> Option<FreePath> {
        Some(if self.killed.get() { FreePath { weight: 0.0, ..path } } else { path })
    }
}

impl Injection for SignedRoulette {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::RatioWeight]
    }
    fn overlay<'a>(&'a self, context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Signed { medium: context.medium, killed: Cell::default() }))
    }
}

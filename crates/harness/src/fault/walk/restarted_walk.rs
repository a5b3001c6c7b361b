use crate::fault::walk_progress::WalkProgress;
use crate::fault::{Injection, Overlay, WalkContext};
use freepath_estimators::{Capability, FreePath};
use std::cell::Cell;

/// After a null collision the walk is back at the start of the ray (a typical slip).
///
/// ```text
/// right: t += dt;   wrong: t = dt
/// ```
///
/// The walk is given up at its first null collision, and drawn again: the same law.
///
/// Shows in: the law of t and the escape atom; nowhere where no collision is null.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RestartedWalk {}

#[derive(Default)]
struct Restart {
    walked: WalkProgress,
    given_up: Cell<bool>,
}

impl Overlay for Restart {
    fn begin(&self) {
        self.walked.begin();
        self.given_up.set(false);
    }
    fn word(&self, stream: &mut dyn FnMut() -> u64) -> u64 {
        if self.walked.lookups.get() == 0 {
            return stream();
        }
        self.given_up.set(true);
        u64::MAX // 36 mean free paths, and then no acceptance
    }
    fn answer(&self, t: f64, mu: f64) -> f64 {
        self.walked.looked_up(t);
        mu
    }
    fn finish(&self, path: FreePath) -> Option<FreePath> {
        (!self.given_up.get()).then_some(path)
    }
}

impl Injection for RestartedWalk {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::Acceptance]
    }
    fn overlay<'a>(&'a self, _context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Restart::default()))
    }
}

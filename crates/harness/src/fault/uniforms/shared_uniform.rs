use crate::fault::walk_progress::WalkProgress;
use crate::fault::{Injection, Overlay, Target, WalkContext};
use freepath_estimators::Capability;
use std::cell::Cell;

/// Step and acceptance use the same uniform (a typical slip).
///
/// ```text
/// right: dt = -ln(1 - u) / mu_bar, real if u' < mu / mu_bar;   wrong: u' = u
/// ```
///
/// Shows in: the law of t and the escape atom; nowhere where every collision is real.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SharedUniform {}

#[derive(Default)]
struct Shared {
    walked: WalkProgress,
    flight: Cell<u64>,
}

impl Overlay for Shared {
    fn begin(&self) {
        self.walked.begin();
    }
    fn word(&self, stream: &mut dyn FnMut() -> u64) -> u64 {
        match self.walked.word() {
            0 => {
                self.flight.set(stream());
                self.flight.get()
            }
            1 => self.flight.get(),
            _ => stream(),
        }
    }
    fn answer(&self, t: f64, mu: f64) -> f64 {
        self.walked.looked_up(t);
        mu
    }
}

impl Injection for SharedUniform {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::Acceptance]
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.under_one_majorant()
    }
    fn overlay<'a>(&'a self, _context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Shared::default()))
    }
}

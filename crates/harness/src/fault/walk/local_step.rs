use crate::fault::walk_progress::{WalkProgress, depth_of, word_of};
use crate::fault::{Injection, Overlay, Target, WalkContext};
use freepath_estimators::{Capability, Extinction};
use std::cell::Cell;

/// The step uses mu where the walk stands, the acceptance the majorant (SCONE, commit dcfd46e0).
///
/// ```text
/// right: dt = -ln(1 - u) / mu_bar;   wrong: dt = -ln(1 - u) / mu(t)
/// ```
///
/// Shows in: the law of t and the escape atom; nowhere in a homogeneous medium under a tight majorant.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LocalStep {}

struct Local<'a> {
    medium: &'a dyn Extinction,
    walked: WalkProgress,
    mu: Cell<f64>,
}

impl Overlay for Local<'_> {
    fn begin(&self) {
        self.walked.begin();
    }
    fn word(&self, stream: &mut dyn FnMut() -> u64) -> u64 {
        let word = stream();
        if self.walked.word() != 0 {
            return word;
        }
        let start = self.walked.lookups.get() == 0;
        let mu = if start { self.medium.mu(0.0) } else { self.mu.get() };
        let mu_bar = self.medium.majorants().mu_bar_at(0.0);
        if mu.to_bits() == mu_bar.to_bits() { word } else { word_of(depth_of(word) * mu_bar / mu) }
    }
    fn answer(&self, t: f64, mu: f64) -> f64 {
        self.walked.looked_up(t);
        self.mu.set(mu);
        mu
    }
}

impl Injection for LocalStep {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::TentativeCollisions]
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.under_one_majorant()
    }
    fn overlay<'a>(&'a self, context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Local { medium: context.medium, walked: WalkProgress::default(), mu: Cell::default() }))
    }
}

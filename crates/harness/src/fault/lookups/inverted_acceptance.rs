use crate::fault::{Injection, Overlay, WalkContext};
use freepath_estimators::{Capability, Extinction};

/// The test of a tentative collision is inverted (Celeritas, issue 888, and again in commit 39c7a5115).
///
/// ```text
/// right: real if u < mu / mu_bar;   wrong: real if u >= mu / mu_bar
/// seen:  mu_bar - mu
/// ```
///
/// Shows in: the law of t strongly, the escape atom weakly; nowhere where mu is half the majorant.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct InvertedAcceptance {}

struct Inverted<'a>(&'a dyn Extinction);

impl Overlay for Inverted<'_> {
    fn answer(&self, t: f64, mu: f64) -> f64 {
        self.0.majorants().mu_bar_at(t) - mu
    }
}

impl Injection for InvertedAcceptance {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::Acceptance]
    }
    fn overlay<'a>(&'a self, context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Inverted(context.medium)))
    }
}

use crate::fault::{Injection, Overlay, WalkContext};
use freepath_estimators::parameter::positive;
use freepath_estimators::{Capability, Extinction, Majorants, Medium, ParameterError};

/// A majorant that is short, and mu clamped to it: the cure of a symptom (pbrt-v4, issue 82; Cycles, commit 7f2a81371).
///
/// ```text
/// right: raise mu_bar, or let weights be negative;   wrong: mu := min(mu, mu_bar), or w *= max(0, 1 - mu / mu_bar)
/// ```
///
/// Shows in: the escape atom, the law of t and the mean; an audit that looks after the clamp is silenced.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ClampedDensity {
    /// Below 1.
    factor: f64,
}

/// Clamps what the audit has seen.
struct Clamp<'a>(&'a dyn Extinction);

impl Overlay for Clamp<'_> {
    fn answer(&self, t: f64, mu: f64) -> f64 {
        let bound = self.0.majorants().mu_bar_at(t);
        if mu > bound { bound } else { mu }
    }
}

impl Injection for ClampedDensity {
    fn check(&self) -> Result<(), ParameterError> {
        positive("factor", self.factor).map(drop)
    }
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::Majorants]
    }
    fn alter_majorants(&self, _truth: &dyn Medium, majorants: Majorants) -> Majorants {
        majorants.map_bounds(|mu_bar| self.factor * mu_bar)
    }
    fn overlay<'a>(&'a self, context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Clamp(context.medium)))
    }
}

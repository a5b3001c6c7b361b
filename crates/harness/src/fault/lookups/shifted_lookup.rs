use crate::fault::{Injection, Overlay, WalkContext};
use freepath_estimators::parameter::finite;
use freepath_estimators::{Capability, ParameterError};

/// Every look-up is a distance away from where it should be: half a step, say (a typical slip).
///
/// ```text
/// right: mu(t);   wrong: mu(t + by), kept on the ray
/// ```
///
/// Shows in: the law of t and the mean; nowhere where mu is constant.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShiftedLookup {
    /// In length units; look-ups are kept on the ray.
    by: f64,
}

struct Shift {
    by: f64,
    length: f64,
}

impl Overlay for Shift {
    fn place(&self, t: f64) -> f64 {
        match t + self.by {
            t if t < 0.0 => 0.0,
            t if t > self.length => self.length,
            t => t,
        }
    }
}

impl Injection for ShiftedLookup {
    fn check(&self) -> Result<(), ParameterError> {
        finite("by", self.by).map(drop)
    }
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::LookUps]
    }
    fn overlay<'a>(&'a self, context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Shift { by: self.by, length: context.medium.length() }))
    }
}

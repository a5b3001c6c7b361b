use super::missing_scale::Times;
use crate::fault::{Injection, Overlay, RayView, WalkContext};
use freepath_estimators::parameter::require;
use freepath_estimators::{Capability, ParameterError};

/// Flights are shortened by an enhanced cross section, and one reaction does not undo it by its weight (EGSnrc, issue 956).
///
/// ```text
/// right: w := w / c at an enhanced event, and (1 - 1 / c) w goes on;   wrong: nothing of that for a share of mu
/// seen:  mu (1 + share (c - 1))
/// ```
///
/// Shows in: the mean and the law of t; hardly where the reaction is rare.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EnhancedCrossSection {
    /// c, at least 1.
    times: f64,
    /// The share of mu that is not made up for.
    share: f64,
}

impl EnhancedCrossSection {
    fn excess(&self) -> f64 {
        1.0 + self.share * (self.times - 1.0)
    }
}

impl Injection for EnhancedCrossSection {
    fn check(&self) -> Result<(), ParameterError> {
        let allowed = self.times >= 1.0 && self.times < f64::INFINITY;
        require(allowed, "times", self.times, "finite and at least 1")?;
        let allowed = self.share >= 0.0 && self.share <= 1.0;
        require(allowed, "share", self.share, "from 0 to 1").map(drop)
    }
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::LookUps]
    }
    fn alter_ray(&self, ray: &mut RayView) {
        ray.majorants = ray.majorants.map(|mu| self.excess() * mu);
    }
    fn overlay<'a>(&'a self, _context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Times(self.excess())))
    }
}

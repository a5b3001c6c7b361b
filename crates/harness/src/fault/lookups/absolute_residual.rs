use super::flipped_residual::control_at;
use crate::fault::{Injection, Overlay, Target, WalkContext};
use freepath_estimators::transmittance::Control;
use freepath_estimators::{Capability, Extinction};

/// Residual tracking with the absolute value of mu - mu_c (a typical slip).
///
/// ```text
/// right: w *= 1 - (mu - mu_c) / rate;   wrong: w *= 1 - |mu - mu_c| / rate
/// seen:  mu_c + |mu - mu_c|
/// ```
///
/// Shows in: the mean; nowhere where the control is the minimum of mu.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AbsoluteResidual {
    /// As the estimator has it.
    control: Control,
}

struct Absolute<'a> {
    control: Control,
    medium: &'a dyn Extinction,
}

impl Overlay for Absolute<'_> {
    fn answer(&self, t: f64, mu: f64) -> f64 {
        let control = control_at(self.control, self.medium.majorants(), t);
        control + (mu - control).abs()
    }
}

impl Injection for AbsoluteResidual {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::Residual(self.control)]
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.has_control(self.control)
    }
    fn overlay<'a>(&'a self, context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Absolute { control: self.control, medium: context.medium }))
    }
}

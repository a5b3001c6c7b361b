use crate::fault::{Injection, Overlay, Target, WalkContext};
use freepath_estimators::transmittance::Control;
use freepath_estimators::{Capability, Extinction, Majorants};

/// Residual tracking with the sign of mu - mu_c flipped (a typical slip).
///
/// ```text
/// right: w *= 1 - (mu - mu_c) / rate;   wrong: w *= 1 + (mu - mu_c) / rate
/// seen:  2 mu_c - mu
/// ```
///
/// Shows in: the mean, but only where the control is not the mean of mu.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FlippedResidual {
    /// As the estimator has it.
    control: Control,
}

/// The control extinction at `t`.
pub(super) fn control_at(control: Control, majorants: &Majorants, t: f64) -> f64 {
    let k = majorants.ends().partition_point(|&end| end <= t);
    let k = if k < majorants.ends().len() { k } else { majorants.ends().len() - 1 };
    match control {
        Control::Mean => majorants.mu_mean()[k],
        Control::Minimum => majorants.mu_min()[k],
        Control::Value(value) => value,
    }
}

struct Flipped<'a> {
    control: Control,
    medium: &'a dyn Extinction,
}

impl Overlay for Flipped<'_> {
    fn answer(&self, t: f64, mu: f64) -> f64 {
        2.0 * control_at(self.control, self.medium.majorants(), t) - mu
    }
}

impl Injection for FlippedResidual {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::Residual(self.control)]
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.has_control(self.control)
    }
    fn overlay<'a>(&'a self, context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Flipped { control: self.control, medium: context.medium }))
    }
}

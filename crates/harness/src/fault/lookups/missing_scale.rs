use crate::fault::{Injection, Overlay, RayView, WalkContext};
use freepath_estimators::parameter::positive;
use freepath_estimators::{Capability, ParameterError};

/// The sampler leaves out the scale that the transmittance has (Tungsten, commit 371e6f4; MCX, commit 4d9cf86, where a factor
/// multiplies instead of dividing).
///
/// ```text
/// right: tau(t) = int mu ds in world units;   wrong: tau(t) = factor int mu ds
/// ```
///
/// Shows in: the law of t, the escape atom; nowhere where the scale is 1.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MissingScale {
    /// The factor of mu that the subject sees: 1 over the scale that is left out.
    factor: f64,
}

/// Sees this many times the extinction.
pub(super) struct Times(pub(super) f64);

impl Overlay for Times {
    fn answer(&self, _t: f64, mu: f64) -> f64 {
        self.0 * mu
    }
}

impl Injection for MissingScale {
    fn check(&self) -> Result<(), ParameterError> {
        positive("factor", self.factor).map(drop)
    }
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::LookUps]
    }
    fn alter_ray(&self, ray: &mut RayView) {
        ray.majorants = ray.majorants.map(|mu| self.factor * mu);
    }
    fn overlay<'a>(&'a self, _context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Times(self.factor)))
    }
}

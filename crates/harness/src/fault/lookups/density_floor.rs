use crate::fault::{Injection, Overlay, RayView, WalkContext};
use freepath_estimators::parameter::positive;
use freepath_estimators::{Capability, ParameterError};

/// A small extinction is raised to a floor, to keep a quotient finite (MCX, commit 3067a26).
///
/// ```text
/// right: dt = depth / mu;   wrong: dt = depth / max(mu, floor)
/// ```
///
/// Shows in: collisions in what is almost empty; nowhere where mu is near 1.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DensityFloor {
    /// In 1/length.
    floor: f64,
}

struct Floor(f64);

impl Overlay for Floor {
    fn answer(&self, _t: f64, mu: f64) -> f64 {
        if mu < self.0 { self.0 } else { mu }
    }
}

impl Injection for DensityFloor {
    fn check(&self) -> Result<(), ParameterError> {
        positive("floor", self.floor).map(drop)
    }
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::LookUps]
    }
    fn alter_ray(&self, ray: &mut RayView) {
        ray.majorants = ray.majorants.map(|mu| if mu < self.floor { self.floor } else { mu });
    }
    fn overlay<'a>(&'a self, _context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Floor(self.floor)))
    }
}

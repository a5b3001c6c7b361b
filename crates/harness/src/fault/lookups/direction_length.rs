use crate::fault::{BlockContext, Injection, Overlay, RayView, WalkContext};
use freepath_draws::{Draws, MissingColumn, column};
use freepath_estimators::parameter::positive;
use freepath_estimators::{Capability, ParameterError};

/// A world distance becomes a ray parameter by multiplying with the length of the direction (pbrt-v3, issue 159).
///
/// ```text
/// right: s = -ln(1 - u) / (mu |d|), t = s |d|;   wrong: s = -ln(1 - u) |d| / mu
/// seen:  mu(s |d|) / |d| on a ray of length / |d|
/// ```
///
/// Shows in: the escape atom and the law of t; nowhere where |d| is 1.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DirectionLength {
    /// |d|.
    length: f64,
}

struct Parameter(f64);

impl Overlay for Parameter {
    fn place(&self, t: f64) -> f64 {
        t * self.0
    }
    fn answer(&self, _t: f64, mu: f64) -> f64 {
        mu / self.0
    }
}

impl Injection for DirectionLength {
    fn check(&self) -> Result<(), ParameterError> {
        positive("length", self.length).map(drop)
    }
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::LookUps]
    }
    fn alter_ray(&self, ray: &mut RayView) {
        let d = self.length;
        ray.length /= d;
        ray.majorants = ray.majorants.map(|mu| mu / d).map_ends(|t| t / d);
        ray.breaks.iter_mut().for_each(|t| *t /= d);
    }
    fn overlay<'a>(&'a self, _context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Parameter(self.length)))
    }
    fn corrupt_draws(&self, _context: &BlockContext, draws: &mut Draws) -> Result<(), MissingColumn> {
        if draws.row().has(column::T) {
            draws.f64_mut(column::T)?.iter_mut().for_each(|t| *t *= self.length);
        }
        Ok(())
    }
}

use super::overlay::{Overlay, Shape, Site};
use super::{BlockPlace, Layer, Plant, Target};
use freepath_estimators::parameter::positive;
use freepath_draws::Draws;
use freepath_estimators::ParameterError;

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

impl Plant for DirectionLength {
    fn layer(&self) -> Layer {
        Layer::LookUps
    }
    fn check(&self) -> Result<(), ParameterError> {
        positive("length", self.length).map(drop)
    }
    fn fits(&self, target: &Target) -> Result<(), String> {
        target.looks_up()
    }
    fn reshape(&self, shape: &mut Shape) {
        let d = self.length;
        shape.length /= d;
        shape.majorants = shape.majorants.map(|mu| mu / d).map_ends(|t| t / d);
        shape.breaks.iter_mut().for_each(|t| *t /= d);
    }
    fn lay<'a>(&'a self, _site: Site<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Parameter(self.length)))
    }
    fn spoil(&self, _at: &BlockPlace, draws: &mut Draws) {
        draws.t.iter_mut().for_each(|t| *t *= self.length);
    }
}

use crate::fault::Injection;
use freepath_estimators::parameter::require;
use freepath_estimators::{Capability, Majorants, Medium, ParameterError};

/// A majorant larger than it need be (pbrt-v4, issue 189: the maxima of two grids are added where that of both suffices).
///
/// ```text
/// right: mu_bar = max mu;   wasteful: mu_bar = times max mu
/// ```
///
/// Shows in: the number of look-ups and of tentative collisions; law and mean are exact, and nothing may call them biased.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LooseMajorant {
    /// At least 1.
    times: f64,
}

impl Injection for LooseMajorant {
    fn check(&self) -> Result<(), ParameterError> {
        let allowed = self.times >= 1.0 && self.times < f64::INFINITY;
        require(allowed, "times", self.times, "finite and at least 1").map(drop)
    }
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::Majorants]
    }
    fn alter_majorants(&self, _truth: &dyn Medium, majorants: Majorants) -> Majorants {
        majorants.map_bounds(|mu_bar| self.times * mu_bar)
    }
}

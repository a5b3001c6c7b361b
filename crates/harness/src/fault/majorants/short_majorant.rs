use crate::fault::Injection;
use freepath_estimators::parameter::positive;
use freepath_estimators::{Capability, Majorants, Medium, ParameterError};

/// A majorant that is a factor of what it should be (pbrt-v4, issue 33: the greatest of some wavelengths and 2.5 % more is no
/// bound).
///
/// ```text
/// right: mu_bar = max mu;   wrong: mu_bar = factor max mu, and a collision is real with probability min(1, mu / mu_bar)
/// ```
///
/// Shows in: look-ups above the majorant, at once; the law of t only near the maximum.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShortMajorant {
    /// Below 1 for a short one.
    factor: f64,
}

impl Injection for ShortMajorant {
    fn check(&self) -> Result<(), ParameterError> {
        positive("factor", self.factor).map(drop)
    }
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::Majorants]
    }
    fn alter_majorants(&self, _truth: &dyn Medium, majorants: Majorants) -> Majorants {
        majorants.map_bounds(|mu_bar| self.factor * mu_bar)
    }
}

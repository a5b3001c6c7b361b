use crate::fault::Injection;
use freepath_estimators::integral::Sampled;
use freepath_estimators::parameter::require;
use freepath_estimators::{Capability, ParameterError};

/// The weights of a mixture sum up to something else than 1 where it is divided by (a typical slip).
///
/// ```text
/// right: sum k_i = 1;   wrong: sum k_i = total, so that the mean is F / total
/// ```
///
/// Shows in: the mean, 4.2424 for 14/3 of a total of 1.1; nowhere near a total of 1.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UnnormalisedMixture {
    /// The sum of the weights.
    #[schemars(example = 1.1)]
    total: f64,
}

impl Injection for UnnormalisedMixture {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::MixtureOfDensities]
    }
    fn check(&self) -> Result<(), ParameterError> {
        require(self.total > 0.0 && self.total <= 1e6, "total", self.total, "above 0 and at most 1e6").map(drop)
    }
    fn divide(&self, _: &Sampled, weight: f64) -> f64 {
        weight / self.total
    }
}

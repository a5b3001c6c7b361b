use crate::fault::Injection;
use freepath_estimators::Capability;
use freepath_estimators::integral::Sampled;

/// The estimate is divided by the density of the component that was drawn, not by that of the mixture (a typical slip).
///
/// ```text
/// right: f / sum_i k_i p_i;   wrong: f / p_i of the component i that was drawn, which has the right mean if each p_i covers f
/// ```
///
/// Shows in: the variance, 6.6222 for 4.8889 of x^2 + x under the halves of 1/2 and x/2; nowhere where all components are one.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ComponentPdf {}

impl Injection for ComponentPdf {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::MixtureOfDensities]
    }
    fn divide(&self, sampled: &Sampled, _: f64) -> f64 {
        if sampled.f.abs() <= 0.0 { 0.0 } else { sampled.f / sampled.component }
    }
}

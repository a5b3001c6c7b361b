use crate::fault::Injection;
use freepath_estimators::Capability;
use freepath_estimators::integral::Sampled;

/// The estimate is not divided by the density of its draw (a typical slip).
///
/// ```text
/// right: f(x)/p(x);   wrong: f(x), whose mean is int f p
/// ```
///
/// Shows in: the mean, 10/3 for 14/3 of x^2 + x under x/2 on [0, 2]; nowhere where the density is 1.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ForgottenPdf {}

impl Injection for ForgottenPdf {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::Density]
    }
    fn divide(&self, sampled: &Sampled, _: f64) -> f64 {
        sampled.f
    }
}

use crate::fault::Injection;
use freepath_estimators::Capability;
use freepath_estimators::integral::Sampled;

/// The density is taken at the uniform that a draw was made of, not at the draw (a typical slip).
///
/// ```text
/// right: f(x)/p(x), x = F^-1(u);   wrong: f(x)/p(u)
/// ```
///
/// Shows in: the mean; nowhere where the density is constant.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DensityOfTheUnwarpedVariable {}

impl Injection for DensityOfTheUnwarpedVariable {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::Density]
    }
    fn divide(&self, sampled: &Sampled, _: f64) -> f64 {
        sampled.f / (sampled.density)(sampled.u)
    }
}

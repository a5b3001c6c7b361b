use super::*;
/// Stub
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
pub struct Stub {}
impl ChromaticSampler for Stub {
    fn sample(&self, _: &[Channel], _: &mut dyn rand::Rng, _: &mut [f64]) -> f64 {
        0.0
    }
}

use super::{Method, Scoring, System, WalkEstimator, Walked, Walks};
use crate::capability::Capability;

/// Walk without variance: every step is drawn in proportion to what it contributes (Kahn and Marshall 1953; Coveyou, Cain and Yost 1967).
///
/// ```text
/// q_i = h_i x_i / <h, x>,   P_ij = H_ij x_j / x_i,   an end with b_i / x_i:   X = <h, x>, always
/// ```
///
/// Target: <h, x>, x = H x + b; it shows what a guide towards the solution would gain, which here is made of the solution itself.
/// Range:  <h, x> alone.
/// Cost:   the states of a walk.
/// Needs:  H, b and h that are not negative, and the system solved beforehand.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ZeroVariance {}

const METHOD: Method = Method { walks: Walks::Guided, scoring: Scoring::End };

impl WalkEstimator for ZeroVariance {
    fn estimate(&self, system: &System, rng: &mut dyn rand::Rng) -> Option<Walked> {
        system.walk(METHOD, rng)
    }
    fn method(&self) -> Option<Method> {
        Some(METHOD)
    }
    fn capabilities(&self) -> Vec<Capability> {
        vec![Capability::EndScore]
    }
}

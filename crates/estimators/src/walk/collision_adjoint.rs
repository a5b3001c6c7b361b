use super::{Method, Scoring, System, WalkEstimator, Walked, Walks};
use crate::capability::Capability;

/// Adjoint collision estimator: a walk from the source along H^T, scored by the detector in every state that it visits (Wasow 1952).
///
/// ```text
/// <h, (1 - H)^-1 b> = <(1 - H^T)^-1 h, b>,   X = sum_m W_m h_i(m),   W_0 = b_i / q_i
/// ```
///
/// Target: the same number as forward; which side is cheaper depends on which of source and detector is small.
/// Range:  not bounded.
/// Cost:   the states of a walk.
/// Needs:  columns of |H| that sum up to 1 at the most, or `adjoint_steps`.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CollisionAdjoint {}

const METHOD: Method = Method { walks: Walks::Adjoint, scoring: Scoring::Visits };

impl WalkEstimator for CollisionAdjoint {
    fn estimate(&self, system: &System, rng: &mut dyn rand::Rng) -> Option<Walked> {
        system.walk(METHOD, rng)
    }
    fn method(&self) -> Option<Method> {
        Some(METHOD)
    }
    fn capabilities(&self) -> Vec<Capability> {
        vec![Capability::WalkTables, Capability::VisitScore]
    }
}

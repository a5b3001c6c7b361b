use super::{Method, Scoring, System, WalkEstimator, Walked, Walks};
use crate::capability::Capability;

/// Collision estimator: scores in every state that a walk from the detector visits, the first and the last included (Wasow 1952).
///
/// ```text
/// X = sum_m W_m b_i(m),   E[X^2] = sum_i (h_i^2 / q_i) [(1 - K)^-1 (b (2 x - b))]_i,   K_ij = H_ij^2 / P_ij
/// ```
///
/// Target: <h, x>, x = H x + b. Of a chain it beats absorption in state j where f_j < (1 - p*_j) / (1 + p*_j), f_j the probability to return.
/// Range:  of a chain whole numbers from 0.
/// Cost:   the states of a walk.
/// Needs:  an end within reach of every state.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Collision {}

const METHOD: Method = Method { walks: Walks::Forward, scoring: Scoring::Visits };

impl WalkEstimator for Collision {
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

use super::{Method, Scoring, System, WalkEstimator, Walked, Walks};
use crate::capability::Capability;

/// Adjoint absorption estimator: a walk from the source along H^T, scored by the detector where it ends (von Neumann and Ulam; Forsythe and Leibler 1950).
///
/// ```text
/// <h, (1 - H)^-1 b> = <(1 - H^T)^-1 h, b>,   X = W_n h_i / p*_i,   W_0 = b_i / q_i
/// ```
///
/// Target: the same number as forward; which side is cheaper depends on which of source and detector is small.
/// Range:  of walks without weights from 0 to the greatest h_i / p*_i by the sum of b.
/// Cost:   the states of a walk.
/// Needs:  columns of |H| that sum up to 1 at the most, or `adjoint_steps`.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AbsorptionAdjoint {}

const METHOD: Method = Method { walks: Walks::Adjoint, scoring: Scoring::End };

impl WalkEstimator for AbsorptionAdjoint {
    fn estimate(&self, system: &System, rng: &mut dyn rand::Rng) -> Option<Walked> {
        system.walk(METHOD, rng)
    }
    fn method(&self) -> Option<Method> {
        Some(METHOD)
    }
    fn capabilities(&self) -> Vec<Capability> {
        vec![Capability::WalkTables, Capability::EndScore]
    }
}

use super::{Method, Scoring, System, WalkEstimator, Walked, Walks};
use crate::capability::Capability;

/// Absorption estimator: scores where a walk from the detector ends (von Neumann and Ulam; Forsythe and Leibler 1950).
///
/// ```text
/// X = W_n b_i / p*_i,   E[X^2] = sum_i (h_i^2 / q_i) [(1 - K)^-1 (b^2 / p*)]_i,   K_ij = H_ij^2 / P_ij
/// ```
///
/// Target: <h, x>, x = H x + b, of spectral radius of |H| below 1; the variance is infinite if that of K is not.
/// Range:  of a chain 0 and 1/p*.
/// Cost:   the states of a walk.
/// Needs:  p*_i > 0 wherever there is a source.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Absorption {}

const METHOD: Method = Method { walks: Walks::Forward, scoring: Scoring::End };

impl WalkEstimator for Absorption {
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

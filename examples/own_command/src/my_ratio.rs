use crate::my_tracker::greatest;
use freepath::{Extinction, TransmittanceEstimator};
use rand::{Rng, RngExt};
use serde::{Deserialize, Serialize};

/// Ratio tracking under one majorant for the whole ray.
///
/// Target: mean T, where the majorant bounds mu.
/// Range:  [0, 1].
/// Cost:   one look-up per tentative collision.
/// Needs:  a majorant.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MyRatio {}

impl TransmittanceEstimator for MyRatio {
    fn estimate(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> f64 {
        let mu_bar = greatest(medium);
        let (mut t, mut weight) = (0.0, 1.0);
        loop {
            t -= libm::log(1.0 - rng.random::<f64>()) / mu_bar;
            if !(t < medium.length()) {
                return weight;
            }
            weight *= 1.0 - medium.mu(t) / mu_bar;
        }
    }
}

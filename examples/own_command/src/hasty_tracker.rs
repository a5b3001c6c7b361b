use crate::my_tracker::greatest;
use freepath::{Extinction, FreePath, FreePathSampler};
use rand::{Rng, RngExt};
use serde::{Deserialize, Serialize};

/// Delta tracking that is wrong: it looks mu up where the step begins, not where it ends.
///
/// Target: the free-path law, which it misses wherever mu varies.
/// Range:  (0, length), or infinity for an escape; weight 1.
/// Cost:   one look-up per tentative collision.
/// Needs:  a majorant.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HastyTracker {}

impl FreePathSampler for HastyTracker {
    fn sample(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
        let mu_bar = greatest(medium);
        let mut t = 0.0;
        loop {
            let mu = medium.mu(t);
            t -= libm::log(1.0 - rng.random::<f64>()) / mu_bar;
            if !(t < medium.length()) {
                return FreePath::at(f64::INFINITY);
            }
            if rng.random::<f64>() * mu_bar < mu {
                return FreePath::at(t);
            }
        }
    }
}

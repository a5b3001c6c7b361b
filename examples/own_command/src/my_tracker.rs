use freepath::parameter::require;
use freepath::{Capability, Extinction, FreePath, FreePathSampler, ParameterError};
use rand::{Rng, RngExt};
use serde::{Deserialize, Serialize};

/// Delta tracking under one majorant for the whole ray, with room above it.
///
/// Target: the free-path law, where the majorant bounds mu.
/// Range:  (0, length), or infinity for an escape; weight 1.
/// Cost:   one look-up per tentative collision.
/// Needs:  a majorant.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MyTracker {
    /// The majorant is taken so many times, at least once.
    #[serde(default = "once")]
    room: f64,
}

fn once() -> f64 {
    1.0
}

impl FreePathSampler for MyTracker {
    fn sample(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
        let mu_bar = self.room * greatest(medium);
        let mut t = 0.0;
        loop {
            t -= libm::log(1.0 - rng.random::<f64>()) / mu_bar;
            if !(t < medium.length()) {
                return FreePath::at(f64::INFINITY);
            }
            if rng.random::<f64>() * mu_bar < medium.mu(t) {
                return FreePath::at(t);
            }
        }
    }

    // what planted faults may lay hold of
    fn capabilities(&self) -> Vec<Capability> {
        vec![Capability::LookUps, Capability::Majorants]
    }

    fn accepts(&self, _medium: &dyn Extinction) -> Result<(), ParameterError> {
        require(self.room >= 1.0 && self.room.is_finite(), "room", self.room, "finite and at least 1").map(drop)
    }
}

/// The greatest majorant of the ray.
pub(crate) fn greatest(medium: &dyn Extinction) -> f64 {
    medium.majorants().mu_bar().iter().fold(0.0, |most, &mu_bar| if mu_bar <= most { most } else { mu_bar })
}

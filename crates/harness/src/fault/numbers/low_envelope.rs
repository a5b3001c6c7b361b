use crate::fault::{Injection, Overlay};
use freepath_estimators::parameter::require;
use freepath_estimators::{Capability, ParameterError};
use std::cell::Cell;

/// The envelope of a rejection is a factor of what it should be: too low where the density is high (a typical slip).
///
/// ```text
/// right: accepted if v C g < p;   wrong: if v (factor C) g < p, so that the law is min(p, factor C g) over its mass
/// ```
///
/// Shows in: the law where the density is high, and in fewer trials; under 1 and above the greatest p / (C g) in fewer trials alone.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LowEnvelope {
    /// The factor, above 0 and below 1.
    #[schemars(range(min = 0.0, max = 1.0), example = 0.8)]
    factor: f64,
}

/// Words of the draw so far.
struct Lowered {
    taken: Cell<u64>,
    factor: f64,
}

impl Overlay for Lowered {
    fn begin(&self) {
        self.taken.set(0);
    }
    fn word(&self, stream: &mut dyn FnMut() -> u64) -> u64 {
        let (word, taken) = (stream(), self.taken.replace(self.taken.get() + 1));
        if taken % 2 == 1 { (word as f64 * self.factor) as u64 } else { word }
    }
}

impl Injection for LowEnvelope {
    fn check(&self) -> Result<(), ParameterError> {
        require(self.factor > 0.0 && self.factor < 1.0, "factor", self.factor, "above 0 and below 1").map(drop)
    }
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::Envelope]
    }
    fn words(&self) -> Option<Box<dyn Overlay + '_>> {
        Some(Box::new(Lowered { taken: Cell::new(0), factor: self.factor }))
    }
}

use crate::fault::walk_progress::WalkProgress;
use crate::fault::{Injection, Overlay, Target, WalkContext};
use freepath_estimators::ParameterError;
use freepath_estimators::parameter::require;
use freepath_estimators::{Capability, FreePath};
use std::cell::Cell;

/// Uniforms that may be exactly 1 meet ln(1 - u): the flight is infinite (PyTorch, issue 2561; Julia, issue 51890).
///
/// ```text
/// right: -ln(1 - u) for u in [0, 1), -ln(u) for u in (0, 1];   wrong: the other pairing
/// here:  u = k / (2^bits - 1), k = 0 .. 2^bits - 1; an infinite flight is an escape
/// ```
///
/// Shows in: escapes from a medium so dense that there are none; in 24 bits, once in 1.7e7 flights.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ClosedEnd {
    /// Bits of the uniforms.
    bits: u32,
}

struct Closed {
    bits: u32,
    walked: WalkProgress,
    infinite: Cell<bool>,
}

impl Overlay for Closed {
    fn begin(&self) {
        self.walked.begin();
        self.infinite.set(false);
    }
    fn word(&self, stream: &mut dyn FnMut() -> u64) -> u64 {
        let (word, most) = (stream(), (1 << self.bits) - 1);
        let k = word >> (64 - self.bits);
        if self.walked.word() == 0 && k == most {
            self.infinite.set(true);
        }
        let u = k as f64 / most as f64;
        if k == most { u64::MAX } else { ((u * 4_503_599_627_370_496.0) as u64) << 12 }
    }
    fn answer(&self, t: f64, mu: f64) -> f64 {
        self.walked.looked_up(t);
        mu
    }
    fn finish(&self, path: FreePath) -> Option<FreePath> {
        let escape = FreePath { t: f64::INFINITY, weight: 1.0, ..path };
        Some(if self.infinite.get() { escape } else { path })
    }
}

impl Injection for ClosedEnd {
    fn check(&self) -> Result<(), ParameterError> {
        require((8..=52).contains(&self.bits), "bits", self.bits, "8 to 52").map(drop)
    }
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::Flights, Capability::Analog]
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.under_one_majorant()
    }
    fn overlay<'a>(&'a self, _context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Closed { bits: self.bits, walked: WalkProgress::default(), infinite: Cell::default() }))
    }
}

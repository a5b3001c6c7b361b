use crate::fault::walk_progress::WalkProgress;
use crate::fault::{Injection, Overlay, Target, WalkContext};
use freepath_draws::random::Spent;
use freepath_estimators::parameter::require;
use freepath_estimators::{Capability, ParameterError};

/// A step of exactly zero is read as no step chosen, and the loop never ends (EGSnrc, issue 179).
///
/// ```text
/// right: t = 0 is an event like any other;   wrong: t = 0 is unset
/// here:  a flight whose uniform is 0 in so many bits, stopped at once as the budget of words would
/// ```
///
/// Shows in: a hang, once in 2^bits flights; for certain where the generator is made to give 0.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ZeroStep {
    /// Bits of the uniforms.
    bits: u32,
}

struct Unset {
    bits: u32,
    walked: WalkProgress,
}

impl Overlay for Unset {
    fn begin(&self) {
        self.walked.begin();
    }
    fn word(&self, stream: &mut dyn FnMut() -> u64) -> u64 {
        let word = stream();
        if self.walked.word() == 0 && word >> (64 - self.bits) == 0 {
            std::panic::resume_unwind(Box::new(Spent));
        }
        word
    }
    fn answer(&self, t: f64, mu: f64) -> f64 {
        self.walked.looked_up(t);
        mu
    }
}

impl Injection for ZeroStep {
    fn check(&self) -> Result<(), ParameterError> {
        require((8..=52).contains(&self.bits), "bits", self.bits, "8 to 52").map(drop)
    }
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::Flights]
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.under_one_majorant()
    }
    fn overlay<'a>(&'a self, _context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Unset { bits: self.bits, walked: WalkProgress::default() }))
    }
}

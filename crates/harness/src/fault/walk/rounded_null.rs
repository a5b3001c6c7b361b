use crate::fault::walk_progress::WalkProgress;
use crate::fault::{Injection, Overlay, Target, WalkContext};
use freepath_estimators::ParameterError;
use freepath_estimators::parameter::require;
use freepath_estimators::{Capability, Extinction, FreePath};
use std::cell::Cell;

/// The probability of a null collision rounds to a little more than 0, and its weight divides 0 by 0 (pbrt-v4, issues 172,
/// 179 and 196).
///
/// ```text
/// right: null with probability (mu_bar - mu) / mu_bar;   wrong: null where u >= 1 - 2^-bits, weight 0 / 0 if mu = mu_bar
/// ```
///
/// Shows in: NaN, once in 2^bits collisions under a tight majorant; for certain where the generator is made to give its
/// greatest number.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RoundedNull {
    /// Bits of the arithmetic: 24 in single precision.
    bits: u32,
}

struct Rounded<'a> {
    bits: u32,
    medium: &'a dyn Extinction,
    walked: WalkProgress,
    /// The acceptance is so near 1.
    null: Cell<bool>,
    spoilt: Cell<bool>,
}

impl Overlay for Rounded<'_> {
    fn begin(&self) {
        self.walked.begin();
        self.spoilt.set(false);
    }
    fn word(&self, stream: &mut dyn FnMut() -> u64) -> u64 {
        let word = stream();
        let last = word >> (64 - self.bits) == (1 << self.bits) - 1;
        self.null.set(self.walked.word() == 1 && last);
        word
    }
    fn answer(&self, t: f64, mu: f64) -> f64 {
        self.walked.looked_up(t);
        if self.null.get() && mu >= self.medium.majorants().mu_bar_at(t) {
            self.spoilt.set(true);
        }
        mu
    }
    fn finish(&self, path: FreePath) -> Option<FreePath> {
        let nan = FreePath { t: f64::NAN, weight: f64::NAN, ..path };
        Some(if self.spoilt.get() { nan } else { path })
    }
}

impl Injection for RoundedNull {
    fn check(&self) -> Result<(), ParameterError> {
        require((8..=52).contains(&self.bits), "bits", self.bits, "8 to 52").map(drop)
    }
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::Acceptance]
    }
    fn accepts(&self, target: &Target) -> Result<(), String> {
        target.under_one_majorant()
    }
    fn overlay<'a>(&'a self, context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        let (null, spoilt) = (Cell::default(), Cell::default());
        Some(Box::new(Rounded {
            bits: self.bits,
            medium: context.medium,
            walked: WalkProgress::default(),
            null,
            spoilt,
        }))
    }
}

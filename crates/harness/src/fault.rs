//! Planted faults: data laid over the majorants, the look-ups or the draws of any subject, so that no broken estimator is
//! ever shipped as one.

use crate::verdict::Reason;
use freepath_estimators::ParameterError;
use freepath_estimators::parameter::{finite, positive, require};
use serde::{Deserialize, Serialize};

mod draws;
mod view;

pub use draws::{BlockPlace, lay_over_draws};
pub use view::{Faulty, needs_scalar};

/// A planted fault that a case can name.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Fault {
    /// The majorant is this factor of what it should be (bugs: a bound found by sampling, padding forgotten).
    ShortMajorant {
        /// Below 1 for a short one.
        factor: f64,
    },
    /// The majorant is this factor of what it should be, and mu is clamped to it (a cure of the symptom).
    ClampedDensity {
        /// Below 1.
        factor: f64,
    },
    /// Every look-up is this far from where it should be: half a step, say.
    ShiftedLookup {
        /// In length units; look-ups are kept on the ray.
        by: f64,
    },
    /// The collision test uses mu at the position before the step.
    StalePosition {},
    /// Weights are divided by the pdf of this channel alone, where the mixture's is due.
    ChannelPdf {
        /// From 0.
        channel: usize,
    },
    /// Estimates below a threshold die by roulette, and the survivors are not raised.
    UncompensatedRoulette {
        /// Estimates below it play.
        below: f64,
        /// Probability of survival.
        survival: f64,
    },
    /// One walk of so many gives NaN.
    NanDraw {
        /// Which, from 0.
        walk: u64,
        /// Of how many.
        of: u64,
    },
    /// Now and then a draw repeats the one before it.
    DuplicatedDraws {
        /// The share of repeats.
        share: f64,
    },
    /// Draws are handed out in the order in which walks end, not in the order in which they start.
    CompletionOrder {
        /// Walks in flight at a time.
        window: usize,
    },
}

impl Fault {
    /// The names that a case may use, and what they do.
    pub const NAMES: &[(&str, &str)] = &[
        ("short_majorant", "the majorant is a factor of what it should be"),
        ("clamped_density", "the majorant is short and mu is clamped to it"),
        ("shifted_lookup", "every look-up is off by a distance, such as half a step"),
        ("stale_position", "the collision test uses mu at the position before the step"),
        ("channel_pdf", "chromatic weights are divided by the pdf of one channel alone"),
        ("uncompensated_roulette", "survivors of a roulette keep their weight"),
        ("nan_draw", "one walk of so many gives NaN"),
        ("duplicated_draws", "now and then a draw repeats the one before it"),
        ("completion_order", "draws are handed out in the order in which walks end"),
    ];

    /// The fault's name in a case.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::ShortMajorant { .. } => "short_majorant",
            Self::ClampedDensity { .. } => "clamped_density",
            Self::ShiftedLookup { .. } => "shifted_lookup",
            Self::StalePosition {} => "stale_position",
            Self::ChannelPdf { .. } => "channel_pdf",
            Self::UncompensatedRoulette { .. } => "uncompensated_roulette",
            Self::NanDraw { .. } => "nan_draw",
            Self::DuplicatedDraws { .. } => "duplicated_draws",
            Self::CompletionOrder { .. } => "completion_order",
        }
    }

    /// Refuses a parameter out of its range.
    ///
    /// # Errors
    /// Naming the value and what is allowed.
    pub fn check(&self) -> Result<(), ParameterError> {
        match *self {
            Self::ShortMajorant { factor } | Self::ClampedDensity { factor } => {
                positive("factor", factor).map(drop)
            }
            Self::ShiftedLookup { by } => finite("by", by).map(drop),
            Self::StalePosition {} | Self::ChannelPdf { .. } => Ok(()),
            Self::UncompensatedRoulette { below, survival } => {
                finite("below", below)?;
                require(survival > 0.0 && survival < 1.0, "survival", survival, "between 0 and 1").map(drop)
            }
            Self::NanDraw { walk, of } => require(walk < of, "walk", walk, "less than `of`").map(drop),
            Self::DuplicatedDraws { share } => {
                require(share > 0.0 && share < 1.0, "share", share, "between 0 and 1").map(drop)
            }
            Self::CompletionOrder { window } => {
                require((2..=16_384).contains(&window), "window", window, "2 to 16384").map(drop)
            }
        }
    }

    /// Whether the fault makes the majorants fall short, on purpose.
    #[must_use]
    pub fn shortens_majorant(&self) -> bool {
        matches!(self, Self::ShortMajorant { .. } | Self::ClampedDensity { .. })
    }
}

/// What a case expects of a subject.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Expectation {
    /// A pass.
    Pass,
    /// A failure with this reason among those found.
    Fail(Reason),
    /// An inconclusive verdict with this reason among those found.
    Inconclusive(Reason),
}

impl Fault {
    /// Whether the fault stands between the subject and its look-ups.
    #[must_use]
    pub fn spoils_lookups(&self) -> bool {
        matches!(self, Self::ClampedDensity { .. } | Self::ShiftedLookup { .. } | Self::StalePosition {})
    }
}

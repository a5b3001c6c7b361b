//! What a subject claims, and how far its claims must be shown to hold.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A claim that a case may withdraw from a subject.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Claim {
    /// That no look-up exceeds the majorant.
    Bounded,
    /// The second moment.
    SecondMoment,
    /// The expected look-ups, and the law of tentative collisions.
    Lookups,
    /// That draws are independent.
    Independent,
    /// All that the optical depth tells: law, mean, moments, ties and look-ups. What remains are agreements, the support, the order
    /// of the draws, the audit, and what is checked without noise.
    Truth,
}

/// How small the bias must be shown to be.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum BiasBound {
    /// In units of the mean; for a free path a probability, the most that its distribution function may be off.
    Absolute(f64),
    /// As a share of the expected mean; for a free path of 1, the greatest value of a distribution function.
    Relative(f64),
}

impl BiasBound {
    /// The bound on the error of something of this size.
    #[must_use]
    pub fn of(self, size: f64) -> f64 {
        match self {
            Self::Absolute(bound) => bound,
            Self::Relative(share) => share * size,
        }
    }
}

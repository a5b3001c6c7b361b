//! Verdicts and the reasons for them.

use serde::{Deserialize, Serialize};
use std::fmt;

/// The verdict of a run on a subject.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// Nothing was rejected, and what could have been missed is stated.
    Pass,
    /// Something could not be judged.
    Inconclusive,
    /// A claim was rejected in both stages, or a fact contradicts it.
    Fail,
}

macro_rules! reasons {
    ($($(#[$doc:meta])* $name:ident = $code:literal: $words:literal,)*) => {
        /// The reason why a verdict is not a pass, most telling first.
        #[derive(
            Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize, Serialize, schemars::JsonSchema,
        )]
        #[serde(rename_all = "snake_case")]
        pub enum Reason { $($(#[$doc])* $name,)* }

        impl Reason {
            /// Every reason.
            pub const ALL: &[Self] = &[$(Self::$name,)*];

            /// The code, as in a case file.
            #[must_use]
            pub fn code(self) -> &'static str {
                match self { $(Self::$name => $code,)* }
            }

            /// Its meaning and usual cause, in words.
            #[must_use]
            pub fn words(self) -> &'static str {
                match self { $(Self::$name => $words,)* }
            }
        }
    };
}

reasons! {
    /// The subject cannot be run.
    SubjectError = "subject_error": "the subject stopped, panicked or ran past its budget; a program crashed, was silent, or wrote too little or too much",
    /// NaN or infinity.
    NonFinite = "non_finite": "draws are NaN or infinite: look for a logarithm of 0, a division by 0, or 0 / 0 in a weight",
    /// Outside the support.
    OutOfSupport = "out_of_support": "draws or look-ups lie outside the ray, where the law has no mass, or outside of their range",
    /// A look-up exceeded the majorant.
    BoundViolated = "bound_violated": "a look-up exceeded the majorant that the subject relies on: the majorant is short, or the density is clamped to it",
    /// Not the same twice.
    NotReproducible = "not_reproducible": "the same seed gave other draws",
    /// The mean is not the truth, or the law is not the medium's.
    Biased = "biased": "the mean or the law is off: a missing factor, a step rule too coarse, a weight that is not compensated",
    /// The law of the draws is not the one claimed.
    WrongLaw = "wrong_law": "the distances do not follow the law that the subject claims: a wrong acceptance test, a stale position, a wrong channel pdf",
    /// The second moment is not the one claimed.
    WrongVariance = "wrong_variance": "the second moment is not the one that the formula gives, or there is noise where none may be: a weight with the right mean and the wrong spread",
    /// The look-ups are not as many as claimed.
    WrongCost = "wrong_cost": "the number of look-ups is not the one that the method must make: skipped or doubled look-ups",
    /// Draws depend on one another.
    Dependent = "dependent": "draws repeat or depend on their neighbours: a reused random number, a copied stream, rows handed out in order of completion",
    /// The tail of the draws is too heavy to judge the mean.
    HeavyTail = "heavy_tail": "a few draws carry the mean, so no interval for it can be trusted",
    /// The event that decides the claim is too rare to be seen.
    RareEvent = "rare_event": "what carries the mean is too rare to be seen in so many draws",
    /// More draws are needed.
    NotEnoughDraws = "not_enough_draws": "too few draws to judge the claim or to meet the bound that was asked for",
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.code())
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Pass => "pass",
            Self::Inconclusive => "inconclusive",
            Self::Fail => "fail",
        })
    }
}

//! Agreement without a truth: a subject against itself in another setting that must not change its law or its mean.
//!
//! | agreement | the same subject |
//! |---|---|
//! | `majorant` | under twice the majorant |
//! | `segments` | under 8 segments, each with its own bound, instead of one; or under one instead of several |
//! | `grid` | in a homogeneous medium, and in the same medium written as a grid of equal nodes |
//! | `reversed` | along the ray and back: the mean, or the share of escapes |
//!
//! Each draws as much again, from streams of its own, and is one two-sample test in each stage. Nobody needs to know tau.

use crate::collect::{Stopped, Watch, collect};
use crate::experiment::{Experiment, Plan};
use crate::subject::Subject;
use freepath_estimators::Medium;
use freepath_statistics::claim::{Agreed, Comparable};
use freepath_statistics::fold::Tallies;
use freepath_statistics::{Evidence, Fact, Judged};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::ops::Range;
use std::sync::Arc;

mod setting;

/// A setting in which a subject must agree with itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Agreement {
    /// Under twice the majorant.
    Majorant,
    /// Under 8 segments instead of one majorant, or under one instead of several.
    Segments,
    /// In a homogeneous medium written as a grid of equal nodes.
    Grid,
    /// Along the reversed ray.
    Reversed,
}

impl Agreement {
    /// Every one.
    pub const ALL: [Self; 4] = [Self::Majorant, Self::Segments, Self::Grid, Self::Reversed];

    /// The name of its test.
    #[must_use]
    pub fn test(self) -> &'static str {
        match self {
            Self::Majorant => "agree_majorant",
            Self::Segments => "agree_segments",
            Self::Grid => "agree_grid",
            Self::Reversed => "agree_reversed",
        }
    }

    /// The medium of the other setting.
    ///
    /// # Errors
    /// If the medium has no such setting, in words.
    pub fn setting(self, truth: &Arc<dyn Medium>) -> Result<Arc<dyn Medium>, String> {
        setting::of(self, truth)
    }

    /// True if distances have the same law there, not only the same share of escapes.
    fn keeps_the_law(self) -> bool {
        match self {
            Self::Majorant | Self::Segments | Self::Grid => true,
            Self::Reversed => false,
        }
    }
}

/// What a subject is compared with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Other {
    /// Itself in another setting.
    Setting(Agreement),
    /// Another file of samples, which is judged beside it.
    Samples {
        /// Draws of its stage 1.
        draws: u64,
        /// The most by which its numbers may be off.
        tolerance: f64,
    },
}

impl Other {
    /// The name of the test.
    #[must_use]
    pub fn test(self) -> &'static str {
        match self {
            Self::Setting(agreement) => agreement.test(),
            Self::Samples { .. } => "agree_samples",
        }
    }

    /// The test, and the blocks that the other draws in the stage of `blocks`: a file has its own.
    fn of(self, subject: &Subject, blocks: Range<u64>) -> (Agreed, Range<u64>) {
        let name = self.test();
        match self {
            Self::Setting(agreement) => {
                let (whole_law, slack) = (agreement.keeps_the_law(), 2.0 * subject.tolerance);
                (Agreed { name, whole_law, slack }, blocks)
            }
            Self::Samples { draws, tolerance } => {
                let first = Subject::blocks(draws);
                let own = if blocks.start == 0 { 0..first } else { first..3 * first };
                (Agreed { name, whole_law: true, slack: subject.tolerance + tolerance }, own)
            }
        }
    }
}

/// What a subject must agree with.
pub struct Variant<'a> {
    /// The setting, or the other subject.
    pub other: Other,
    /// The subject there.
    pub experiment: Box<dyn Experiment + 'a>,
}

/// The findings of an agreement.
pub struct Compared {
    /// Of the two-sample test.
    pub evidence: Evidence,
    /// Facts against a claim in the other setting.
    pub facts: Vec<Fact>,
    /// Of another subject, what its own claims say; nothing of a setting, which is of the same subject.
    pub own: Judged,
}

/// Draws `subject` in the setting of `variant` and compares it with what was tallied in its own.
///
/// # Errors
/// If the subject fails there, or the run is cancelled.
pub fn agree(
    subject: &Subject,
    plan: &Plan,
    variant: &Variant,
    own: &Tallies,
    seed: u64,
    blocks: Range<u64>,
    watch: &Watch,
) -> Result<Compared, Stopped> {
    let key = subject.key ^ crate::hash::hash(variant.other.test());
    let (test, blocks) = variant.other.of(subject, blocks);
    let there = Subject { experiment: &*variant.experiment, key, ..subject.clone() };
    let claimed = there.plan();
    let there = own.assumed.map_or(there.clone(), |probable| there.assuming(probable));
    let other = collect(&there, &claimed.claims.folds, seed, blocks, watch)?.tallies;
    let evidence = Comparable::agree(plan.claims.comparable(own), claimed.claims.comparable(&other), &test);
    let Judged { evidence: tests, facts, gates } = claimed.claims.judge(&other);
    let own = match variant.other {
        Other::Setting(_) => Judged::default(),
        Other::Samples { .. } => {
            Judged { evidence: tests.into_iter().map(of_other).collect(), gates, facts: Vec::new() }
        }
    };
    Ok(Compared { evidence, facts, own })
}

/// A test of the other subject, under a name of its own.
fn of_other(test: Evidence) -> Evidence {
    Evidence { name: format!("other_{}", test.name), ..test }
}

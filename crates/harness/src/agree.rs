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

use crate::collect::{Collected, Stopped, Watch, collect};
use crate::judge::judge;
use crate::plan::Plan;
use crate::subject::{Scene, Subject};
use freepath_estimators::Medium;
use freepath_statistics::hypothesis::{Sample, agree_atom, agree_law, agree_mean};
use freepath_statistics::{Evidence, Fact};
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
}

/// The other setting of one agreement.
pub struct Variant {
    /// Which.
    pub agreement: Agreement,
    /// The medium under the majorants that the subject should have.
    pub truth: Arc<dyn Medium>,
    /// The same under those that it sees.
    pub seen: Arc<dyn Medium>,
}

/// Draws `subject` in the setting of `variant` and compares it with what was collected in its own: the evidence, and what
/// contradicts a claim there.
///
/// # Errors
/// If the subject fails there, or the run is cancelled.
pub fn agree(
    subject: &Subject,
    plan: &Plan,
    variant: &Variant,
    own: &Collected,
    seed: u64,
    blocks: Range<u64>,
    watch: &Watch,
) -> Result<(Evidence, Vec<Fact>), Stopped> {
    let scene = Scene::Grey { truth: &variant.truth, seen: &variant.seen };
    let key = subject.key ^ crate::hash::hash(variant.agreement.test());
    let there = Subject { scene, key, ..subject.clone() };
    let other = collect(&there, plan, seed, blocks, watch)?;
    let facts = judge(&there, plan, &other).facts;
    Ok((evidence(subject, plan, variant.agreement, own, &other), facts))
}

/// One two-sample test: of the means, or of the escapes and, along the same ray, of the distances of the others.
fn evidence(subject: &Subject, plan: &Plan, which: Agreement, own: &Collected, other: &Collected) -> Evidence {
    let name = which.test();
    if let (Some(a), Some(b), Some(mean)) = (&own.mean, &other.mean, &plan.mean) {
        let (range, slack) = (mean.truth.range, 2.0 * subject.tolerance);
        return agree_mean(name, [a, b], &Sample { range, binary: mean.truth.binary, slack });
    }
    let cells = [own, other].map(|seen| seen.counts.cells.as_ref());
    match (cells, &plan.law) {
        ([Some(a), Some(b)], Some(law)) => {
            let slack = 2.0 * subject.tolerance;
            if which == Agreement::Reversed {
                agree_atom(name, [a, b], slack, law.reason)
            } else {
                agree_law(name, [a, b], slack, law.reason)
            }
        }
        _ => Evidence::withheld(name, f64::NAN, freepath_results::Reason::WrongLaw, "there is nothing to compare"),
    }
}

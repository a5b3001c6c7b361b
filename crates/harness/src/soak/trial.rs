//! The subjects that are soaked: those whose claims hold.

use crate::case::{Prepared, PreparedSubject};
use crate::collect::{Stopped, Watch, observe};
use crate::experiment::Plan;
use crate::fault::Expectation;
use crate::run::{Cancelled, id};
use crate::subject::Subject;
use freepath_results::Reason;
use freepath_statistics::Judged;
use freepath_statistics::claim::Design;
use std::ops::Range;

/// A right subject with its plan, made once for all runs.
pub(super) struct Trial<'a> {
    pub(super) id: String,
    pub(super) subject: Subject<'a>,
    plan: Plan<'a>,
}

/// Every subject without a fault that is not stated to fail. Finished files are left out: they hold the same draws for every
/// seed.
pub(super) fn right(cases: &[Prepared]) -> Vec<Trial<'_>> {
    let mut all = Vec::new();
    for case in cases {
        for prepared in case.subjects.iter().filter(|prepared| sound(prepared)) {
            let subject = prepared.runnable(&case.case);
            let plan = subject.plan();
            all.push(Trial { id: id(case, prepared), subject, plan });
        }
    }
    all
}

fn sound(prepared: &PreparedSubject) -> bool {
    prepared.source.is_none()
        && prepared.faults.is_empty()
        && matches!(prepared.spec.expect, None | Some(Expectation::Pass))
}

impl Trial<'_> {
    /// Blocks of stage 1.
    pub(super) fn blocks(&self) -> u64 {
        Subject::blocks(self.subject.draws)
    }

    /// Draws of stage 1.
    pub(super) fn draws(&self) -> u64 {
        self.blocks() * self.subject.rows as u64
    }

    /// The evidence of some blocks, of the claims that hold: a subject that is biased by design is held to its own law or mean
    /// alone.
    pub(super) fn judged(&self, seed: u64, blocks: Range<u64>, watch: &Watch) -> Result<Judged, Cancelled> {
        let mut judged = match observe(&self.subject, &self.plan, seed, blocks, watch) {
            Ok(seen) => self.plan.claims.judge(&seen.tallies),
            Err(Stopped::Cancelled) => return Err(Cancelled),
            Err(Stopped::Subject(why)) => Judged::broken(why),
        };
        if self.plan.claims.design(self.subject.draws) != Design::Unbiased {
            judged.evidence.retain(|evidence| evidence.reason != Reason::Biased);
        }
        Ok(judged)
    }
}

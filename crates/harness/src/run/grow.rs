//! Draws double until the bias is bounded as the case asks, the subject is rejected, or the budget ends.
//!
//! The error of growth is part of the run's. What a sequence says against a bias of 0 becomes a p-value that holds at every
//! number of draws, p = 1 / max e, and enters Holm's procedure of stage 1 beside all others. If it is at most that of a
//! suspect, stage 2 grows fresh draws, up to twice as many, and their p-value enters Holm's procedure of stage 2. So growth
//! spends no error of its own: its p-values take the roads of all others, and a run's false alarms stay at 1e-6. The other tests
//! are read once, at the case's draws. A finished file has no more draws: it is looked at once in each stage. A bound is stated at the reporting level; the level of a mean of known range is split
//! between its bets and its interval.

use super::Cancelled;
use crate::blocks::{GROWTH, GROWTH_OF_STAGE_TWO};
use crate::collect::{Collected, Stopped, Watch, collect};
use crate::experiment::Plan;
use crate::subject::{BLOCK, Subject};
use freepath_results::{Grown, GrownOutcome, Real, Reason};
use freepath_statistics::Judged;
use freepath_statistics::check;
use freepath_statistics::claim::{Asked, InterimLook, SequentialTest};
use freepath_statistics::fold::Folds;
use freepath_statistics::{Evidence, Fact};
use std::ops::Range;

/// Growth ends with a rejection at this p-value: Holm's procedure confirms it among up to 70,000 others.
const REJECTED: f64 = 1e-8;

/// The context of growth beside the subject.
pub(super) struct Growth<'a> {
    /// The run's seed.
    pub(super) seed: u64,
    /// Told of draws done.
    pub(super) watch: &'a Watch<'a>,
    /// Told of draws to come.
    pub(super) planned: &'a dyn Fn(u64),
}

impl Growth<'_> {
    /// Grows the draws of stage 1 if the case asks for a bound: what was reached, with evidence, facts and gates in `judged`.
    pub(super) fn towards_bound(
        &self,
        subject: &Subject,
        plan: &Plan,
        first: &Collected,
        judged: &mut Judged,
    ) -> Result<Option<Grown>, Cancelled> {
        let Some(mut test) = test(subject, plan) else { return Ok(None) };
        let (mut seen, mut at) = (first.clone(), GROWTH);
        loop {
            let (look, draws) = (test.look(&seen.tallies), seen.tallies.draws);
            let Some(outcome) = outcome(subject, &test, &look, draws, judged) else {
                let blocks = Subject::blocks(draws);
                let folds = test.next(&plan.claims.folds, &seen.tallies);
                match self.more(subject, plan, &folds, at..at + blocks, judged)? {
                    Some(more) => seen.extend(&folds, &more),
                    None => return Ok(None),
                }
                at += blocks;
                continue;
            };
            return Ok(Some(close(outcome, &look, &test, draws, judged)));
        }
    }

    /// Grows the draws of stage 2, up to `most`, until they reject a bias of 0 too: the evidence of stage 2. The draws taken.
    pub(super) fn confirm(
        &self,
        subject: &Subject,
        plan: &Plan,
        second: Collected,
        most: u64,
        judged: &mut Judged,
    ) -> Result<u64, Cancelled> {
        let (mut seen, mut at) = (second, GROWTH_OF_STAGE_TWO);
        let Some(mut test) = test(subject, plan) else { return Ok(seen.tallies.draws) };
        loop {
            let (look, draws) = (test.look(&seen.tallies), seen.tallies.draws);
            let fresh = if subject.finished() { 0 } else { most.saturating_sub(draws) };
            let left = Subject::blocks(fresh);
            if !(look.p > REJECTED) || left == 0 {
                judged.evidence.push(test.evidence(&look, draws));
                return Ok(draws);
            }
            let double = Subject::blocks(draws);
            let blocks = if left < double { left } else { double };
            let folds = test.next(&plan.claims.folds, &seen.tallies);
            match self.more(subject, plan, &folds, at..at + blocks, judged)? {
                Some(more) => seen.extend(&folds, &more),
                None => return Ok(draws),
            }
            at += blocks;
        }
    }

    /// The draws of more blocks; none if the subject does not finish them. A fact in them counts as any other.
    fn more(
        &self,
        subject: &Subject,
        plan: &Plan,
        folds: &Folds,
        blocks: Range<u64>,
        judged: &mut Judged,
    ) -> Result<Option<Collected>, Cancelled> {
        (self.planned)((blocks.end - blocks.start) * BLOCK as u64);
        match collect(subject, folds, self.seed, blocks, self.watch) {
            Ok(more) => {
                judged.facts.extend(plan.claims.judge(&more.tallies).facts);
                Ok(Some(more))
            }
            Err(Stopped::Cancelled) => Err(Cancelled),
            Err(Stopped::Subject(why)) => {
                judged.facts.push(Fact::new(check::SUBJECT.name, Reason::SubjectError, why));
                Ok(None)
            }
        }
    }
}

/// The test that the draws grow under; none if the case asks for no bound, or for one that no claim can be held to.
fn test<'a>(subject: &Subject, plan: &'a Plan) -> Option<SequentialTest<'a>> {
    let asked = Asked { bound: subject.bias_bound?, draws: subject.draws, budget: subject.budget };
    plan.claims.sequential(&asked)
}

/// The end of growth at these draws; none if it goes on.
fn outcome(
    subject: &Subject,
    test: &SequentialTest,
    look: &InterimLook,
    draws: u64,
    judged: &Judged,
) -> Option<GrownOutcome> {
    if rejected_already(judged) || !(look.p > REJECTED) {
        Some(GrownOutcome::Rejected)
    } else if look.bound <= test.target() {
        Some(GrownOutcome::Proven)
    } else if 2 * draws > subject.budget || subject.finished() {
        Some(GrownOutcome::BudgetEnded)
    } else {
        None
    }
}

/// The outcome after the decision: what the draws of growth reject in both stages, or in one alone, is rejected, wherever they ended.
pub(super) fn settled(grown: Grown, rejected: bool) -> Grown {
    if !rejected || grown.outcome == GrownOutcome::Rejected {
        return grown;
    }
    let note = format!("rejected after {} draws, and confirmed", grown.draws);
    Grown { outcome: GrownOutcome::Rejected, note, ..grown }
}

/// True if a fact, or a test of stage 1, has rejected the subject beyond doubt.
fn rejected_already(judged: &Judged) -> bool {
    let beyond = |evidence: &Evidence| evidence.judged_p().is_some_and(|p| !(p > REJECTED));
    !judged.facts.is_empty() || judged.evidence.iter().any(beyond)
}

/// Notes the outcome in `judged`: its evidence, and a gate if the bound is not proven.
fn close(
    outcome: GrownOutcome,
    look: &InterimLook,
    test: &SequentialTest,
    draws: u64,
    judged: &mut Judged,
) -> Grown {
    let (target, bound) = (test.asked, test.with_slack(look.bound));
    let after = format!("{} <= {bound:.2e} after {draws} draws, {target:.2e} was asked for", test.what);
    let note = match outcome {
        GrownOutcome::Proven => format!("proven: {after}"),
        GrownOutcome::Rejected => format!("rejected after {draws} draws"),
        GrownOutcome::BudgetEnded => format!("the budget ended: {after}"),
    };
    let gate = match (outcome, &look.withheld) {
        (GrownOutcome::Proven, _) => None,
        (GrownOutcome::Rejected, _) => Some((Reason::NotEnoughDraws, format!("growth: {note}, not confirmed"))),
        (GrownOutcome::BudgetEnded, None) => Some((Reason::NotEnoughDraws, format!("growth: {note}"))),
        (GrownOutcome::BudgetEnded, Some((reason, why))) => Some((*reason, format!("growth: {note}; {why}"))),
    };
    judged.gates.extend(gate);
    judged.evidence.push(test.evidence(look, draws));
    let method = look.method.to_string();
    Grown { draws, outcome, target: Real(target), bound: Real(bound), p: Real(look.p), method, note }
}

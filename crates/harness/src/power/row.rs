//! One subject, at growing draws.

use super::FAMILY;
use super::outcome::Outcome;
use super::words::words;
use crate::case::{Prepared, PreparedSubject};
use crate::fault::Expectation;
use crate::run::{Cancelled, Expected, Options, expected, id, run_stages, whole};
use freepath_results::{FEWEST_DRAWS, PowerRow, Role, Rung};
use freepath_results::{Reason, Verdict};
use freepath_statistics::claim::Design;
use freepath_statistics::decide::Decision;

/// The result expected of a row, and the reason that it must fail for, if a particular one.
struct Aim {
    role: Role,
    reason: Option<Reason>,
}

impl Aim {
    fn of(prepared: &PreparedSubject, design: Design) -> Self {
        match prepared.spec.expect {
            _ if prepared.spec.masks_fault => Self::plain(Role::Hidden),
            Some(Expectation::Fail(reason)) => Self { role: Role::Caught, reason: Some(reason) },
            Some(Expectation::Pass) => Self::plain(Role::Passes),
            Some(Expectation::Inconclusive(_)) => Self::plain(Role::Open),
            None if !prepared.faults.is_empty() => Self::plain(Role::Caught),
            None => match design {
                Design::Seen => Self { role: Role::Caught, reason: Some(Reason::Biased) },
                Design::Unbiased | Design::Hidden => Self::plain(Role::Passes),
                Design::Unsure => Self::plain(Role::Open),
            },
        }
    }

    fn plain(role: Role) -> Self {
        Self { role, reason: None }
    }

    /// The number of p-values taken for the run: many where one must be seen, no others where all must be silent.
    fn family(&self) -> usize {
        if self.role == Role::Caught { FAMILY } else { 0 }
    }
}

/// The findings on one subject.
struct Found {
    aim: Aim,
    expected: String,
    as_expected: bool,
    silent: bool,
    /// At full effort.
    full: Outcome,
    climb: Climb,
}

/// The findings below the full effort.
#[derive(Default)]
struct Climb {
    /// At the fewest draws at which the subject fails as it must, if there are any.
    fewest: Option<Outcome>,
    /// All that was tried.
    ladder: Vec<Rung>,
}

/// One subject at full effort and, if it must be caught and is, at growing draws.
pub(super) fn row(case: &Prepared, prepared: &PreparedSubject, options: &Options) -> Result<PowerRow, Cancelled> {
    let trial = run_stages(case, prepared, None, options)?;
    let (design, draws) = (trial.subject.design(&trial.plan), whole(prepared.draws));
    let aim = Aim::of(prepared, design);
    let full = Outcome::of(&trial, draws, aim.family());
    let silent = Outcome::of(&trial, draws, 0).silent();
    let held = |decision: &Decision| expected(prepared.spec.expect, !prepared.faults.is_empty(), design, decision);
    let Expected { words: expected, met: as_expected, .. } = held(&full.decision);
    let mut found = Found { aim, expected, as_expected, silent, full, climb: Climb::default() };
    if found.caught() && prepared.source.is_none() {
        let fails = |decision: &Decision| decision.verdict == Verdict::Fail && held(decision).met;
        found.climb = climb(case, prepared, options, &fails)?;
    }
    Ok(found.row(case, prepared))
}

/// The doublings below the full effort, up to the first at which the subject `fails` as it must; and that one.
fn climb(
    case: &Prepared,
    prepared: &PreparedSubject,
    options: &Options,
    fails: &dyn Fn(&Decision) -> bool,
) -> Result<Climb, Cancelled> {
    let (mut draws, mut climbed) = (FEWEST_DRAWS, Climb::default());
    while draws < whole(prepared.draws) {
        let outcome = Outcome::of(&run_stages(case, prepared, Some(draws), options)?, draws, FAMILY);
        climbed.ladder.push(outcome.rung.clone());
        if fails(&outcome.decision) {
            climbed.fewest = Some(outcome);
            break;
        }
        draws *= 2;
    }
    Ok(climbed)
}

impl Found {
    fn caught(&self) -> bool {
        self.aim.role == Role::Caught && self.as_expected
    }

    fn row(self, case: &Prepared, prepared: &PreparedSubject) -> PowerRow {
        let decisive = self.climb.fewest.as_ref().unwrap_or(&self.full);
        PowerRow {
            id: id(case, prepared),
            file: case.file.clone(),
            case: case.case.title.clone(),
            ray: case.ray,
            subject: prepared.name.clone(),
            estimator: prepared.spec.estimator().into(),
            kind: prepared.spec.kind().into(),
            fault: prepared.faults.iter().map(words).collect::<Vec<_>>().join(" + "),
            medium: words(&case.case.scene_json()),
            role: self.aim.role,
            as_expected: self.as_expected && (self.aim.role != Role::Hidden || self.silent),
            draws: self.full.rung.draws,
            needed: self.caught().then_some(decisive.rung.draws),
            first: decisive.first(self.aim.reason),
            fired: decisive.fired.clone(),
            silent: self.silent,
            ladder: self.climb.ladder.into_iter().chain([self.full.rung]).collect(),
            verdict: self.full.decision.verdict,
            reasons: self.full.decision.reasons,
            expected: self.expected,
        }
    }
}

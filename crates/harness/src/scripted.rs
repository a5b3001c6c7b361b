//! Scripted generators: every subject is also driven by the ends of [0, 1), which no amount of sampling meets.
//!
//! A logarithm of 0 has a probability of 2^-53 for each draw. Here the words that give 0, 2^-53, 2^-52, 2^-24, 1/2,
//! 1 - 2^-24 and the largest uniform below 1 stand at each of the first eight positions of an otherwise real stream, and
//! constant and alternating at the first 64; through the scalar method and through the block method, where a word goes to a
//! whole row of lanes. A finding is a fact.
//!
//! | seen | reason |
//! |---|---|
//! | NaN; an infinite weight | `non_finite` |
//! | an escape from a medium of optical depth 1000, where the law has none | `non_finite` |
//! | a draw or a look-up outside the ray, a weight outside its claimed range | `out_of_support` |
//! | a collision in the same medium made empty, an estimate there that is not 1 where it has no noise | `out_of_support` |
//! | a panic; the budget of look-ups or random words spent | `subject_error` |
//!
//! After the script every stream is real again, since under one that never changes a right subject need not end, and to
//! break it off would spoil what it holds. A loop that neither looks up nor takes random words cannot be ended by anyone.
//!
//! Cost: some 3,000 draws for each method, and at most 10^6 look-ups.

use crate::blocks::SCRIPTS;
use crate::experiment::Plan;
use crate::sample::{Unfinished, sample_from};
use crate::subject::{Route, Subject};
use freepath_draws::random::Script;
use freepath_draws::{Draws, Key, Streams};
use freepath_results::Reason;
use freepath_statistics::Fact;
use freepath_statistics::check::Check;
use freepath_statistics::claim::Finding;
use freepath_statistics::tally::Audit;

mod script;
mod thick;
mod vacuum;

pub(crate) use script::Scripted;

/// The record of the check.
pub(crate) const CHECK: Check = Check {
    name: "scripted",
    words: "A fact: driven by uniforms at the ends of [0, 1) (0, 2^-53, 2^-24, 1/2, the largest below 1) at each of the first eight \
positions of its stream and at the first 64, a subject gave NaN, an infinity where a finite value is due, a draw or a look-up outside the ray, or did not end.",
    details: "\
Each word stands at each of the first eight positions of a real stream, and alone or in turn with another at the first 64,
through the scalar and the block method. A medium of optical depth 1000, where nobody escapes, brings out -ln(0) for a step; the same medium made empty
under its own majorant brings out a collision that is accepted at u = mu / mu_bar = 0.
Gives non_finite, out_of_support or subject_error. Some 3,000 draws for each method; a uniform of exactly 0 comes once in
2^53 draws otherwise.",
    section: "scripted",
};

/// Most look-ups of one method: a subject that makes more for a draw meets fewer scripts, the first positions first.
const MOST_LOOKUPS: u64 = 1_000_000;

/// Facts that the ends of [0, 1) bring out in `subject`: at most one for each method and reason.
#[must_use]
pub(crate) fn scripted(subject: &Subject, plan: &Plan, seed: u64) -> Vec<Fact> {
    let routes = if subject.one_by_one() { &[Route::Scalar] } else { subject.experiment.routes() };
    routes.iter().flat_map(|&route| by(&Subject { route, ..subject.clone() }, plan, seed)).collect()
}

/// Every script through one method.
fn by(subject: &Subject, plan: &Plan, seed: u64) -> Vec<Fact> {
    let rows = rows(subject.route);
    let (mut draws, mut found, mut lookups) =
        (Draws::new(&subject.experiment.row(), rows), Findings::default(), 0);
    for (i, scripted) in Scripted::all(Key { seed, subject: subject.key, block: SCRIPTS }).enumerate() {
        let key = Key { seed, subject: subject.key, block: SCRIPTS + i as u64 };
        match drive(subject, key, &scripted.script, &mut draws) {
            Ok(audit) => {
                lookups += audit.lookups;
                found.add(&scripted, plan.claims.look(&draws));
                found.add(&scripted, outside(audit.outside));
            }
            Err(Unfinished::Spent(why) | Unfinished::Broken(why)) => {
                found.add(&scripted, Some(Finding { reason: Reason::SubjectError, what: why }));
                break; // one hang is enough
            }
        }
        if lookups > MOST_LOOKUPS {
            break;
        }
    }
    found.extend(thick::escapes(subject, seed));
    found.extend(vacuum::collisions(subject, seed));
    found.facts(subject.route)
}

/// Draws of each script: enough for one uniform a draw to meet every position, and two rows of lanes.
fn rows(route: Route) -> usize {
    if route == Route::Block { 40 } else { 8 }
}

/// Look-ups outside the ray.
fn outside(lookups: u64) -> Option<Finding> {
    let what = || format!("{lookups} look-ups lie outside the ray");
    (lookups > 0).then(|| Finding { reason: Reason::OutOfSupport, what: what() })
}

/// Draws behind `script`: their look-ups.
fn drive(subject: &Subject, key: Key, script: &Script, draws: &mut Draws) -> Result<Audit, Unfinished> {
    sample_from(subject, Streams::new(key).scripted(script.clone()), draws).map(|record| record.audit)
}

/// The first finding of each reason, and how many scripts gave it.
#[derive(Default)]
struct Findings(Vec<Found>);

/// A finding, and how many scripts gave one of its reason.
struct Found {
    reason: Reason,
    what: String,
    scripts: usize,
}

impl Findings {
    fn add(&mut self, scripted: &Scripted, finding: Option<Finding>) {
        let Some(Finding { reason, what }) = finding else { return };
        self.note(Found { reason, what: format!("{}: {what}", scripted.name), scripts: 1 });
    }

    fn note(&mut self, more: Found) {
        match self.0.iter_mut().find(|found| found.reason == more.reason) {
            Some(found) => found.scripts += more.scripts,
            None => self.0.push(more),
        }
    }

    fn extend(&mut self, more: Findings) {
        more.0.into_iter().for_each(|found| self.note(found));
    }

    fn facts(self, route: Route) -> Vec<Fact> {
        let method = if route == Route::Block { "in blocks" } else { "one by one" };
        let fact = |Found { reason, what, scripts }| {
            let more =
                if scripts > 1 { format!(" (and under {} more scripts)", scripts - 1) } else { String::new() };
            Fact::new(CHECK.name, reason, format!("drawn {method} with {what}{more}"))
        };
        self.0.into_iter().map(fact).collect()
    }
}

//! A second start of a program that passes: what it gives must be fresh.

use super::{Cancelled, Options, Progress, Trial};
use crate::blocks::{BLOCK, SECOND_START};
use crate::collect::{Stopped, Watch, observe};
use freepath_results::Reason;
use freepath_statistics::Fact;
use freepath_statistics::check::SUBJECT;

/// Blocks of a second start: 65,536 rows.
const BLOCKS: u64 = 4;

/// Starts a program of which stage 1 gives no cause for a stage 2 once more, under another seed. What is wrong for certain with its rows is a
/// fact, rows of stage 1 among them: a generator that shares some of its draws between seeds passes every test of one start.
pub(super) fn second_start(trial: &mut Trial, options: &Options) -> Result<(), Cancelled> {
    let Trial { prepared, subject, plan, first, .. } = trial;
    let program = subject.experiment.external().is_some() && !subject.finished();
    let Some(before) = first.collected.as_ref().filter(|_| program) else { return Ok(()) };
    let progress = |of| (options.progress)(of, &prepared.name);
    progress(Progress::Planned(BLOCKS * BLOCK as u64));
    let tell = |draws| progress(Progress::Done(draws));
    let watch = Watch { cancelled: options.cancelled, progress: &tell };
    let facts = match observe(subject, plan, options.seed, SECOND_START..SECOND_START + BLOCKS, &watch) {
        Ok(later) => {
            let mut facts = plan.claims.judge(&later.tallies).facts;
            facts.extend(plan.claims.between(&before.tallies, &later.tallies, "a second start"));
            facts
        }
        Err(Stopped::Cancelled) => return Err(Cancelled),
        Err(Stopped::Subject(why)) => vec![Fact::new(SUBJECT.name, Reason::SubjectError, why)],
    };
    first.judged.facts.extend(facts);
    Ok(())
}

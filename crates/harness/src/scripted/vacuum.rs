//! Where there is nothing to collide with every draw escapes and every estimate is 1, whatever the uniform: a collision there is one that is
//! accepted at u = mu / mu_bar = 0.

use super::{Findings, Scripted};
use crate::blocks::SCRIPTS;
use crate::experiment::Experiment;
use crate::sample::sample_from;
use crate::subject::Subject;
use freepath_draws::{Draws, Key, Streams, column};
use freepath_results::Reason;
use freepath_statistics::claim::Finding;

/// Most look-ups of one method, as for thick media.
const MOST_LOOKUPS: u64 = 100_000;

/// Draws of a real stream, and of each script.
const ROWS: [usize; 2] = [64, 4];

/// Positions that are scripted.
const POSITIONS: usize = 3;

/// Collisions of a subject in its own medium made empty, and estimates that are not 1. Not asked of one that is biased by design, nor of one
/// that does not heed the medium: that collides in vacuum under a real stream, or never in its own medium.
pub(super) fn collisions(subject: &Subject, seed: u64) -> Findings {
    let mut all = Findings::default();
    let mut run = |experiment: &dyn Experiment| all.extend(of(subject, experiment, seed).unwrap_or_default());
    subject.experiment.in_vacuum(&subject.terms(), &mut run);
    all
}

fn of(subject: &Subject, experiment: &dyn Experiment, seed: u64) -> Option<Findings> {
    let empty = Subject { experiment, ..subject.clone() };
    let key = |i: u64| Key { seed, subject: subject.key, block: SCRIPTS + 2000 + i };
    let mut draws = Draws::new(&experiment.row(), ROWS[0]);
    sample_from(subject, Streams::new(key(0)), &mut draws).ok()?;
    stopped(&draws, subject)?; // else nothing tells that it would stop if it could
    sample_from(&empty, Streams::new(key(0)), &mut draws).ok()?;
    if stopped(&draws, subject).is_some() {
        return None; // it does not heed the medium
    }
    let (mut found, mut lookups) = (Findings::default(), 0);
    let mut draws = Draws::new(&experiment.row(), ROWS[1]);
    for (i, scripted) in Scripted::prefixes(key(0), POSITIONS).enumerate() {
        let streams = Streams::new(key(1 + i as u64)).scripted(scripted.script.clone());
        let Ok(record) = sample_from(&empty, streams, &mut draws) else { break };
        found.add(&scripted, stopped(&draws, subject));
        lookups += record.audit.lookups;
        if lookups > MOST_LOOKUPS {
            break;
        }
    }
    Some(found)
}

/// The first draw that met something.
fn stopped(draws: &Draws, subject: &Subject) -> Option<Finding> {
    let near = |x: f64| (x - 1.0).abs() <= 1e-9 + subject.tolerance;
    let (x, what) = match (draws.f64(column::T), draws.f64(column::WEIGHT)) {
        (Ok(t), _) => (t.iter().find(|&&t| t != f64::INFINITY)?, "a distance"),
        (Err(_), Ok(weight)) => (weight.iter().find(|&&x| !near(x))?, "an estimate of"),
        (Err(_), Err(_)) => return None,
    };
    let reason = if x.is_nan() { Reason::NonFinite } else { Reason::OutOfSupport };
    Some(Finding { reason, what: format!("{what} {x:e} in a medium that is empty (mu = 0)") })
}

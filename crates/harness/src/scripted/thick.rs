//! In a medium so thick that a double cannot tell T from 0 nobody escapes, whatever the uniform: an escape there is an
//! infinity where a finite value is due, such as -ln(0) for a step.

use super::{Findings, Scripted};
use crate::blocks::SCRIPTS;
use crate::experiment::Experiment;
use crate::sample::sample_from;
use crate::subject::Subject;
use freepath_draws::{Draws, Key, Streams, column};
use freepath_results::Reason;
use freepath_statistics::claim::Finding;

/// exp(-1000) is 0.
const DEPTH: f64 = 1000.0;

/// Most look-ups of one method, for walks through vacuum under a thick majorant: the first positions come first.
const MOST_LOOKUPS: u64 = 100_000;

/// Draws of each script.
const ROWS: usize = 4;

/// Positions that are scripted: the first step and its collision test, and the next.
const POSITIONS: usize = 3;

/// Escapes of a sampler from its own medium made thick. Not asked of one that is biased by design, nor of one that does not
/// heed the medium: one that draws the same distances in both, or escapes from the thick one under a real stream.
pub(super) fn escapes(subject: &Subject, seed: u64) -> Findings {
    let mut found = Findings::default();
    let mut run = |experiment: &dyn Experiment| found = in_thick(subject, experiment, seed).unwrap_or_default();
    subject.experiment.in_thick(&subject.terms(), DEPTH, &mut run);
    found
}

fn in_thick(subject: &Subject, experiment: &dyn Experiment, seed: u64) -> Option<Findings> {
    let thick = Subject { experiment, ..subject.clone() };
    let key = |i: u64| Key { seed, subject: subject.key, block: SCRIPTS + 1000 + i };
    let (mut own, mut draws) = (Draws::new(&subject.experiment.row(), ROWS), Draws::new(&experiment.row(), ROWS));
    sample_from(subject, Streams::new(key(0)), &mut own).ok()?;
    sample_from(&thick, Streams::new(key(0)), &mut draws).ok()?;
    let mut pairs = own.f64(column::T).ok()?.iter().zip(draws.f64(column::T).ok()?);
    if escaped(&draws) || pairs.any(|(a, b)| a.to_bits() == b.to_bits()) {
        return None; // it does not heed the medium
    }
    let (mut found, mut lookups) = (Findings::default(), 0);
    for (i, scripted) in Scripted::prefixes(key(0), POSITIONS).enumerate() {
        let streams = Streams::new(key(1 + i as u64)).scripted(scripted.script.clone());
        let Ok(record) = sample_from(&thick, streams, &mut draws) else { break };
        if escaped(&draws) {
            let what = format!("an escape from a medium of optical depth {DEPTH}, where a finite distance is due");
            found.add(&scripted, Some(Finding { reason: Reason::NonFinite, what }));
        }
        lookups += record.audit.lookups;
        if lookups > MOST_LOOKUPS {
            break;
        }
    }
    Some(found)
}

fn escaped(draws: &Draws) -> bool {
    draws.f64(column::T).is_ok_and(|t| t.iter().any(|&t| !(t < f64::INFINITY)))
}

//! In a medium so thick that a double cannot tell T from 0 nobody escapes, whatever the uniform: an escape there is an
//! infinity where a finite value is due, such as -ln(0) for a step.

use super::{Findings, Scripted};
use crate::blocks::SCRIPTS;
use crate::plan::Plan;
use crate::sample::{columns, sample_from};
use crate::subject::{Scene, Subject, Work};
use freepath_draws::{Draws, Key, Streams, column};
use freepath_estimators::Medium;
use freepath_estimators::medium::{ChromaticMedium, scaled};
use freepath_results::Reason;

/// exp(-1000) is 0.
const DEPTH: f64 = 1000.0;

/// Tentative collisions under the thick medium's majorants at the most.
const MOST_COLLISIONS: f64 = 50.0 * DEPTH;

/// Most look-ups of one method, for walks through vacuum under a thick majorant: the first positions come first.
const MOST_LOOKUPS: u64 = 100_000;

/// Draws of each script.
const ROWS: usize = 4;

/// Positions that are scripted: the first step and its collision test, and the next.
const POSITIONS: usize = 3;

/// Escapes of a sampler from its own medium made thick. Not asked of one that is biased by design, nor of one that does not
/// heed the medium: one that draws the same distances in both, or escapes from the thick one under a real stream.
pub(super) fn escapes(subject: &Subject, plan: &Plan, seed: u64) -> Findings {
    let by_design = plan.law.as_ref().is_none_or(|law| law.own.is_some());
    match (subject.work, subject.scene) {
        _ if by_design => Findings::default(),
        (Work::FreePath(_), Scene::Grey { truth, seen }) => grey(subject, truth, seen, seed).unwrap_or_default(),
        (Work::Chromatic(_), Scene::Chromatic(medium)) => chromatic(subject, medium, seed).unwrap_or_default(),
        _ => Findings::default(),
    }
}

fn grey(subject: &Subject, truth: &dyn Medium, seen: &dyn Medium, seed: u64) -> Option<Findings> {
    let by = DEPTH / truth.tau(truth.length());
    if !(by.is_finite() && by * seen.majorants().depth(seen.length()) <= MOST_COLLISIONS) {
        return None;
    }
    let (truth, seen) = (scaled(by, truth).ok()?, scaled(by, seen).ok()?);
    let Work::FreePath(sampler) = subject.work else { return None };
    sampler.accepts(&seen).ok()?;
    in_thick(subject, Scene::Grey { truth: &truth, seen: &seen }, seed)
}

fn chromatic(subject: &Subject, medium: &ChromaticMedium, seed: u64) -> Option<Findings> {
    let rates = medium.media().iter().map(|(channel, _)| channel.tau(medium.length()));
    let thinnest = rates.fold(f64::INFINITY, |least, tau| if tau < least { tau } else { least });
    let by = DEPTH / thinnest;
    let thick = if by.is_finite() { medium.with(by, medium.length()).ok()? } else { return None };
    in_thick(subject, Scene::Chromatic(&thick), seed)
}

fn in_thick(subject: &Subject, scene: Scene, seed: u64) -> Option<Findings> {
    let thick = Subject { scene, ..subject.clone() };
    let key = |i: u64| Key { seed, subject: subject.key, block: SCRIPTS + 1000 + i };
    let (mut own, mut draws) = (columns(subject, ROWS), columns(&thick, ROWS));
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
            let why = format!("an escape from a medium of optical depth {DEPTH}, where a finite distance is due");
            found.add(&scripted, Some((Reason::NonFinite, why)));
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

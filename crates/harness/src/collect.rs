//! Runs blocks of draws on all threads and folds what they leave.

use crate::experiment::{Beside, Plan};
use crate::sample::{Unfinished, sample_from};
use crate::subject::Subject;
use freepath_draws::{Draws, Key, Streams};
use freepath_statistics::fold::{Folds, Tallies};
use freepath_statistics::{Block, Scratch};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

mod external;
mod worker;

pub(crate) use external::rehearse;
use worker::{BlockParts, Workers};

/// Blocks whose float sums are held at a time.
const WAVE: u64 = 256;

/// The reason why a range of blocks was not finished.
#[derive(Clone, Debug, PartialEq)]
pub enum Stopped {
    /// The subject panicked or ran past its budget, in words.
    Subject(String),
    /// The run was cancelled.
    Cancelled,
}

/// The progress of a run, and the flag that stops it.
pub struct Watch<'a> {
    /// Set to cancel.
    pub cancelled: &'a AtomicBool,
    /// Called with the number of draws of each finished wave.
    pub progress: &'a (dyn Fn(u64) + Sync),
}

impl Watch<'_> {
    fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }
}

/// Everything that was folded from a range of blocks.
#[derive(Clone)]
pub struct Collected {
    /// The tallies of the folds.
    pub tallies: Tallies,
    /// Seconds of sampling, summed over threads.
    pub seconds: f64,
}

impl Collected {
    fn new(folds: &Folds) -> Self {
        Self { tallies: folds.tallies(), seconds: 0.0 }
    }

    /// Takes in the next block, in block order.
    fn fold(&mut self, folds: &Folds, block: &BlockParts) {
        folds.fold(&mut self.tallies, &block.parts);
        self.tallies.draws += block.rows;
        self.seconds += block.seconds;
    }

    /// Takes in later draws.
    pub(crate) fn extend(&mut self, folds: &Folds, later: &Self) {
        folds.extend(&mut self.tallies, &later.tallies);
        self.seconds += later.seconds;
    }
}

/// The draws of a stage, and those that its claims need beside them.
///
/// # Errors
/// If the subject fails or the run is cancelled.
pub fn observe(
    subject: &Subject,
    plan: &Plan,
    seed: u64,
    blocks: Range<u64>,
    watch: &Watch,
) -> Result<Collected, Stopped> {
    let key = Key { seed, subject: subject.key, block: blocks.start };
    let beside = plan.beside.iter().map(|beside| one_block(subject, beside, key).map_err(Stopped::Subject));
    let beside = if blocks.is_empty() { Vec::new() } else { beside.collect::<Result<_, _>>()? };
    let mut collected = with_escapes(subject, plan, seed, blocks, watch)?;
    collected.tallies.beside = beside;
    Ok(collected)
}

/// The draws of `blocks`; once more with what probably stands for an escape counted as one, if they can be had again.
fn with_escapes(
    subject: &Subject,
    plan: &Plan,
    seed: u64,
    blocks: Range<u64>,
    watch: &Watch,
) -> Result<Collected, Stopped> {
    let collected = collect(subject, &plan.claims.folds, seed, blocks.clone(), watch)?;
    let Some(probable) = plan.claims.probable_escape(&collected.tallies) else { return Ok(collected) };
    let silent = Watch { progress: &|_| (), ..*watch };
    match collect(&subject.assuming(probable), &plan.claims.folds, seed, blocks, &silent) {
        Ok(mut again) => {
            again.tallies.assumed = Some(probable);
            Ok(again)
        }
        Err(Stopped::Cancelled) => Err(Stopped::Cancelled),
        Err(Stopped::Subject(_)) => Ok(collected), // a stream is read once
    }
}

/// One block of draws beside the subject's own, on streams of their own.
fn one_block(subject: &Subject, beside: &Beside, key: Key) -> Result<Tallies, String> {
    let key = Key { subject: key.subject ^ beside.salt, ..key };
    let there = Subject { experiment: &*beside.experiment, ..subject.clone() };
    let mut draws = Draws::new(&beside.experiment.row(), subject.rows);
    let record = sample_from(&there, Streams::new(key), &mut draws).map_err(Unfinished::words)?;
    let block = Block { draws: &draws, number: key.block, nth: 0, audit: Some(&record.audit) };
    let (folds, mut counts) = (&beside.folds, beside.folds.empty());
    let observed = folds.observe(&block, &mut Scratch::default(), &mut counts);
    let parts = observed.map_err(|missing| missing.to_string())?;
    let mut tallies = folds.tallies();
    folds.fold(&mut tallies, &parts);
    folds.count(&mut tallies, &counts);
    tallies.draws = subject.rows as u64;
    Ok(tallies)
}

/// The draws of `blocks`, folded: the same for any number of threads.
///
/// # Errors
/// If the subject fails or the run is cancelled; of several failures, that of the first block.
pub(crate) fn collect(
    subject: &Subject,
    folds: &Folds,
    seed: u64,
    blocks: Range<u64>,
    watch: &Watch,
) -> Result<Collected, Stopped> {
    if let Some(source) = subject.experiment.external() {
        return external::collect(source, subject, folds, seed, blocks, watch);
    }
    let (workers, mut collected, mut start) = (Workers::new(), Collected::new(folds), blocks.start);
    let key = |block| Key { seed, subject: subject.key, block };
    let mut later = None;
    if folds.wait_for_first() && !blocks.is_empty() {
        let first = workers.with(subject, folds, |worker| worker.first(subject, folds, key(start)));
        let (block, after) = first.map_err(Stopped::Subject)?;
        collected.fold(folds, &block);
        (watch.progress)(subject.rows as u64);
        (later, start) = (Some(after), start + 1);
    }
    let folds = later.as_ref().unwrap_or(folds);
    let run = |block| {
        if watch.is_cancelled() {
            return Err(String::new());
        }
        workers.with(subject, folds, |worker| worker.run(subject, folds, key(block), block - blocks.start))
    };
    while start < blocks.end {
        let after = start + WAVE;
        let end = if after < blocks.end { after } else { blocks.end };
        let wave: Vec<_> = (start..end).into_par_iter().map(run).collect();
        if watch.is_cancelled() {
            return Err(Stopped::Cancelled);
        }
        for block in wave {
            collected.fold(folds, &block.map_err(Stopped::Subject)?);
        }
        (watch.progress)((end - start) * subject.rows as u64);
        start = end;
    }
    workers.count(folds, &mut collected.tallies);
    Ok(collected)
}

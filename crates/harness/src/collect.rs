//! Runs blocks of draws on all threads and folds what they leave.

use crate::plan::Plan;
use crate::subject::{Subject, Work};
use freepath_draws::Key;
use rayon::prelude::*;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

mod collected;
mod counts;
mod joint;
mod samples;
mod worker;

pub use collected::Collected;
pub use counts::Counts;
pub use joint::Joint;
pub(crate) use samples::rehearse;
use worker::Workers;

/// Blocks whose float sums are held at a time.
const WAVE: u64 = 256;

/// Blocks at the start of a range in which all ties are counted and all look-ups placed.
const FIRST_BLOCKS: u64 = 4;

/// Why a range of blocks was not finished.
#[derive(Clone, Debug, PartialEq)]
pub enum Stopped {
    /// The subject panicked or ran past its budget, in words.
    Subject(String),
    /// The run was cancelled.
    Cancelled,
}

/// What a run tells while it goes on, and whether it is to stop.
pub struct Watch<'a> {
    /// Set to cancel.
    pub cancelled: &'a AtomicBool,
    /// Called with the number of draws of each finished wave.
    pub progress: &'a (dyn Fn(u64) + Sync),
}

/// The draws of `blocks`, folded: the same for any number of threads.
///
/// # Errors
/// If the subject fails or the run is cancelled; of several failures, that of the first block.
pub fn collect(
    subject: &Subject,
    plan: &Plan,
    seed: u64,
    blocks: Range<u64>,
    watch: &Watch,
) -> Result<Collected, Stopped> {
    if let Work::Samples(_, source) = subject.work {
        return samples::collect(source, subject, plan, seed, blocks, watch);
    }
    let (workers, mut collected, mut start) = (Workers::new(), Collected::new(plan), blocks.start);
    let cancelled = || watch.cancelled.load(Ordering::Relaxed);
    let run = |block| {
        let key = Key { seed, subject: subject.key, block };
        if cancelled() { Err(String::new()) } else { workers.run(subject, plan, key, block - blocks.start) }
    };
    while start < blocks.end {
        let after = start + WAVE;
        let end = if after < blocks.end { after } else { blocks.end };
        let wave: Vec<_> = (start..end).into_par_iter().map(run).collect();
        if cancelled() {
            return Err(Stopped::Cancelled);
        }
        for block in wave {
            collected.fold(&block.map_err(Stopped::Subject)?);
        }
        (watch.progress)((end - start) * subject.rows as u64);
        start = end;
    }
    collected.counts = workers.counts().unwrap_or_default();
    collected.fit_tails();
    Ok(collected)
}

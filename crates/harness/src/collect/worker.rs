use crate::sample::sample_block;
use crate::samples::mark_escapes;
use crate::subject::{BLOCK, Subject};
use freepath_draws::{Draws, Key, column};
use freepath_statistics::fold::{Counts, Folds, Parts, Tallies};
use freepath_statistics::tally::Audit;
use freepath_statistics::{Block, Scratch};
use std::sync::{Mutex, PoisonError};

/// The parts that one block leaves.
pub(super) struct BlockParts {
    /// Its number.
    pub(super) number: u64,
    pub(super) rows: u64,
    /// Its float sums.
    pub(super) parts: Parts,
    pub(super) seconds: f64,
}

/// A worker's buffers and counts.
pub(super) struct Worker {
    pub(super) draws: Draws,
    scratch: Scratch,
    counts: Counts,
}

/// The place of a block that has been drawn, and what it took.
pub(super) struct Drawn<'a> {
    pub(super) number: u64,
    /// Its place in its range.
    pub(super) nth: u64,
    pub(super) audit: Option<&'a Audit>,
    pub(super) seconds: f64,
}

impl Worker {
    fn new(subject: &Subject, folds: &Folds) -> Self {
        let draws = Draws::new(&subject.experiment.row(), subject.rows);
        Self { draws, scratch: Scratch::default(), counts: folds.empty() }
    }

    /// One block, the `nth` of its range.
    pub(super) fn run(
        &mut self,
        subject: &Subject,
        folds: &Folds,
        key: Key,
        nth: u64,
    ) -> Result<BlockParts, String> {
        let row = key.block * BLOCK as u64;
        let watch = folds.watch(nth, &mut self.counts);
        let record = sample_block(subject, key, row, &mut self.draws, watch)?;
        let (number, audit, seconds) = (key.block, Some(&record.audit), record.seconds);
        self.tally(subject, folds, &Drawn { number, nth, audit, seconds })
    }

    /// The first block of its range, and the folds of those after it.
    pub(super) fn first(
        &mut self,
        subject: &Subject,
        folds: &Folds,
        key: Key,
    ) -> Result<(BlockParts, Folds), String> {
        let block = self.run(subject, folds, key, 0)?;
        Ok((block, self.folds_after_first(folds, key.block)?))
    }

    /// The folds of the blocks after the one that was folded last, the first of its range.
    ///
    /// # Errors
    /// If the block lacks a column that a claim reads, in words.
    pub(super) fn folds_after_first(&self, folds: &Folds, number: u64) -> Result<Folds, String> {
        let first = Block { draws: &self.draws, number, nth: 0, audit: None };
        folds.after_first(&first).map_err(|missing| missing.to_string())
    }

    /// Folds the draws of a block.
    ///
    /// # Errors
    /// If the block lacks a column that a claim reads, in words.
    pub(super) fn tally(&mut self, subject: &Subject, folds: &Folds, drawn: &Drawn) -> Result<BlockParts, String> {
        let Drawn { number, nth, audit, seconds } = *drawn;
        if let Some(rule) = subject.assumed {
            let t = self.draws.f64_mut(column::T).map_err(|missing| missing.to_string())?;
            mark_escapes(t, rule, subject.tolerance);
        }
        let block = Block { draws: &self.draws, number, nth, audit };
        let parts = folds.observe(&block, &mut self.scratch, &mut self.counts);
        let parts = parts.map_err(|missing| missing.to_string())?;
        Ok(BlockParts { number, rows: self.draws.rows() as u64, parts, seconds })
    }
}

/// A worker for each thread of the pool and one for a thread outside it, made when it is first wanted.
pub(super) struct Workers(Vec<Mutex<Option<Worker>>>);

impl Workers {
    pub(super) fn new() -> Self {
        let slots = rayon::current_num_threads() + 1;
        Self((0..slots).map(|_| Mutex::new(None)).collect())
    }

    /// Puts the worker of this thread to `work`.
    pub(super) fn with<T>(&self, subject: &Subject, folds: &Folds, work: impl FnOnce(&mut Worker) -> T) -> T {
        let slot = &self.0[rayon::current_thread_index().map_or(0, |i| i + 1)];
        let mut slot = slot.lock().unwrap_or_else(PoisonError::into_inner);
        work(slot.get_or_insert_with(|| Worker::new(subject, folds)))
    }

    /// Adds the counts of all workers.
    pub(super) fn count(self, folds: &Folds, tallies: &mut Tallies) {
        for slot in self.0 {
            if let Some(worker) = slot.into_inner().unwrap_or_else(PoisonError::into_inner) {
                folds.count(tallies, &worker.counts);
            }
        }
    }
}

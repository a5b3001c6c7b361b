//! Draws that come in one after another: they are read by one thread at a time and folded by all.

use super::worker::{BlockParts, Drawn, Worker, Workers};
use super::{Collected, Stopped, WAVE, Watch};
use crate::samples::{Rows, SampleSource, Wanted};
use crate::subject::{BLOCK, Subject};
use freepath_draws::Draws;
use freepath_results::Reason;
use freepath_statistics::Fact;
use freepath_statistics::claim::Withdrawal;
use freepath_statistics::fold::Folds;
use rayon::prelude::*;
use std::ops::Range;
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

/// The rows of a stage, and the number of the block that comes next.
struct Reader<'a> {
    rows: Box<dyn Rows + 'a>,
    blocks: Range<u64>,
}

/// A block that was read.
struct ReadBlock {
    number: u64,
    seconds: f64,
}

/// A block that could not be read.
struct Unread {
    block: u64,
    why: String,
}

type Read = Result<BlockParts, Unread>;

impl Reader<'_> {
    /// The next block; none at the end.
    fn next(&mut self, draws: &mut Draws) -> Option<Result<ReadBlock, Unread>> {
        let (started, block) = (Instant::now(), self.blocks.next()?);
        draws.resize(BLOCK);
        match self.rows.read(draws) {
            Err(why) => {
                self.blocks.start = self.blocks.end;
                Some(Err(Unread { block, why }))
            }
            Ok(0) => {
                self.blocks.start = self.blocks.end;
                None
            }
            Ok(rows) => {
                draws.resize(rows);
                Some(Ok(ReadBlock { number: block, seconds: started.elapsed().as_secs_f64() }))
            }
        }
    }
}

impl Worker {
    /// The next block, whichever it is.
    fn take(&mut self, subject: &Subject, folds: &Folds, reader: &Mutex<Reader>, first: u64) -> Option<Read> {
        let next = reader.lock().unwrap_or_else(PoisonError::into_inner).next(&mut self.draws)?;
        Some(next.and_then(|ReadBlock { number, seconds }| {
            let drawn = Drawn { number, nth: number - first, audit: None, seconds };
            self.tally(subject, folds, &drawn).map_err(|why| Unread { block: number, why })
        }))
    }
}

/// The first block of a range, and the folds of those after it.
struct First {
    block: BlockParts,
    later: Folds,
}

impl Worker {
    /// The first block of a range; none if there is no row.
    fn take_first(
        &mut self,
        subject: &Subject,
        folds: &Folds,
        reader: &Mutex<Reader>,
        first: u64,
    ) -> Option<Result<First, Unread>> {
        let read = self.take(subject, folds, reader, first)?;
        Some(read.and_then(|block| {
            let later = self.folds_after_first(folds, block.number);
            later.map(|later| First { block, later }).map_err(|why| Unread { block: first, why })
        }))
    }
}

/// Whoever is cancelled may well fail.
fn failed(why: String, watch: &Watch) -> Stopped {
    if watch.is_cancelled() { Stopped::Cancelled } else { Stopped::Subject(why) }
}

/// Facts from a few draws before any stage, of a subject whose draws are made elsewhere.
pub(crate) fn rehearse(subject: &Subject, seed: u64, watch: &Watch) -> Result<Vec<Fact>, Stopped> {
    let Some(source) = subject.experiment.external() else { return Ok(Vec::new()) };
    let wanted = Wanted { seed, subject: subject.key, blocks: 0..0, cancelled: watch.cancelled };
    let mut facts = source.rehearse(&wanted).map_err(|why| failed(why, watch))?;
    let withdrawn = subject.without.contains(&Withdrawal::Reproducible);
    facts.retain(|fact| !(withdrawn && fact.reason == Reason::NotReproducible));
    Ok(facts)
}

/// The rows of `blocks`, folded: the same for any number of threads, since blocks are put in order before their sums are
/// added.
pub(super) fn collect(
    source: &dyn SampleSource,
    subject: &Subject,
    folds: &Folds,
    seed: u64,
    blocks: Range<u64>,
    watch: &Watch,
) -> Result<Collected, Stopped> {
    let wanted = Wanted { seed, subject: subject.key, blocks: blocks.clone(), cancelled: watch.cancelled };
    let rows = source.open(&wanted).map_err(|why| failed(why, watch))?;
    let (workers, mut collected) = (Workers::new(), Collected::new(folds));
    let reader = Mutex::new(Reader { rows, blocks: blocks.clone() });
    let mut later = None;
    if folds.wait_for_first() {
        let first =
            workers.with(subject, folds, |worker| worker.take_first(subject, folds, &reader, blocks.start));
        if let Some(First { block, later: after }) =
            first.transpose().map_err(|unread| failed(unread.why, watch))?
        {
            collected.fold(folds, &block);
            (watch.progress)(collected.tallies.draws);
            later = Some(after);
        }
    }
    let folds = later.as_ref().unwrap_or(folds);
    let take = |_| {
        if watch.is_cancelled() {
            return None;
        }
        workers.with(subject, folds, |worker| worker.take(subject, folds, &reader, blocks.start))
    };
    loop {
        let mut wave: Vec<Read> = (0..WAVE).into_par_iter().filter_map(take).collect();
        if watch.is_cancelled() {
            return Err(Stopped::Cancelled);
        }
        wave.sort_by_key(|read| read.as_ref().map_or_else(|unread| unread.block, |block| block.number));
        let (before, full) = (collected.tallies.draws, wave.len() as u64 == WAVE);
        for read in wave {
            collected.fold(folds, &read.map_err(|unread| Stopped::Subject(unread.why))?);
        }
        (watch.progress)(collected.tallies.draws - before);
        if !full {
            break;
        }
    }
    workers.count(folds, &mut collected.tallies);
    Ok(collected)
}

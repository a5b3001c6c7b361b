//! Runs blocks of draws on all threads and folds what they leave.

use crate::audit::Audit;
use crate::plan::Plan;
use crate::sample::{columns, sample_block};
use crate::sequence::Capitals;
use crate::subject::{BLOCK, Subject, Work};
use crate::tally::{
    Batch, Batches, CellTally, CountTally, Extremes, LagTally, PowerSums, Running, Tail, TieTally,
};
use crate::test::BlockLookups;
use freepath_estimators::{Draws, Key};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

mod joint;
mod samples;

pub use joint::Joint;
pub(crate) use samples::rehearse;

/// Blocks whose float sums are held at a time.
const WAVE: u64 = 256;

/// Blocks at the start of a range in which all ties are counted and all look-ups placed.
const FIRST_BLOCKS: u64 = 4;

/// What a worker counts: integers, which merge in any order.
#[derive(Clone, Debug, Default)]
pub struct Counts {
    /// Free paths by cell.
    pub cells: Option<CellTally>,
    /// The free paths nearest to either end.
    pub ends: Option<Box<Extremes>>,
    /// Tentative collisions.
    pub collisions: Option<CountTally>,
    /// Neighbouring draws.
    pub lag: LagTally,
    /// Equal draws.
    pub ties: TieTally,
    /// What goes with the distances.
    pub joint: Joint,
    /// Free paths whose weight is not 1.
    pub weighted: u64,
    /// Distances that are NaN, and those outside the ray, where no law counts them.
    pub strays: [u64; 2],
    /// Look-ups by block.
    pub lookups: BlockLookups,
    /// Look-ups, all told.
    pub audit: Audit,
    /// Of the column `weight`, or of each chromatic claim: the largest, where their range is not known.
    pub tails: Vec<Option<Tail>>,
}

/// Everything that was folded from a range of blocks.
#[derive(Clone, Debug)]
pub struct Collected {
    /// Integers.
    pub counts: Counts,
    /// Of the column `weight`.
    pub mean: Option<PowerSums>,
    /// The running mean.
    pub running: Running,
    /// Variance and cost of the column `weight` by groups of blocks.
    pub batches: Batches,
    /// What the bets of the plan gained.
    pub capitals: Capitals,
    /// Of the weights of each chromatic claim.
    pub channels: Vec<PowerSums>,
    /// Draws taken.
    pub draws: u64,
    /// Seconds of sampling, summed over threads.
    pub seconds: f64,
}

/// Why a range of blocks was not finished.
#[derive(Clone, Debug, PartialEq)]
pub enum Stopped {
    /// The subject panicked or ran past its budget, in words.
    Subject(String),
    /// The run was cancelled.
    Cancelled,
}

/// The float sums of one block.
struct BlockSums {
    /// The block's number.
    block: u64,
    rows: u64,
    mean: Option<PowerSums>,
    /// None of draws that come from a file.
    lookups: u64,
    capitals: Capitals,
    channels: Vec<PowerSums>,
    seconds: f64,
    /// For the first block: sums over its first draws.
    early: Vec<PowerSums>,
}

/// A worker's buffers and counts.
struct Worker {
    draws: Draws,
    index: Vec<u32>,
    masked: Vec<f64>,
    counts: Counts,
}

impl Worker {
    fn new(subject: &Subject, plan: &Plan) -> Self {
        let cells = plan.law.as_ref().map(|law| CellTally::new(&law.truth));
        let ends = plan.law.as_ref().map(|law| Box::new(Extremes::new(law.truth.length())));
        let joint = plan.law.as_ref().filter(|law| law.coleman).map(|law| CountTally::joint(&law.truth));
        let collisions = joint.or_else(|| plan.poisson.map(|_| CountTally::marginal()));
        let tails = plan.tails().into_iter().map(|keep| keep.then(Tail::default)).collect();
        let joint = Joint::new(plan);
        let counts = Counts { cells, ends, collisions, joint, tails, ..Counts::default() };
        Self { draws: columns(subject, subject.rows), index: Vec::new(), masked: Vec::new(), counts }
    }

    /// One block, the `nth` of its range.
    fn run(&mut self, subject: &Subject, plan: &Plan, key: Key, nth: u64) -> Result<BlockSums, String> {
        let (row, first) = (key.block * BLOCK as u64, nth < FIRST_BLOCKS);
        if nth == 0 {
            self.counts.joint.in_parts(subject, plan, key, &mut self.draws, &mut self.index)?;
        }
        let watch = self.counts.joint.watch(first);
        let record = sample_block(subject, key, row, &mut self.draws, watch.as_ref())?;
        self.counts.audit = self.counts.audit.plus(record.audit);
        self.counts.lookups.observe(record.audit.lookups);
        let sums = self.tally(plan, key.block, first, record.seconds);
        self.counts.joint.watched(watch, &self.index);
        Ok(BlockSums { lookups: record.audit.lookups, ..sums })
    }

    /// Folds the draws of `block`, which took so many seconds.
    fn tally(&mut self, plan: &Plan, block: u64, first: bool, seconds: f64) -> BlockSums {
        self.count(plan, first);
        let early = if block == 0 { self.early(plan) } else { Vec::new() };
        let mean = plan.mean.as_ref().map(|mean| PowerSums::of(mean.truth.expected, &self.draws.weight));
        if let (Some(_), Some(Some(tail))) = (&mean, self.counts.tails.first_mut()) {
            tail.observe(&self.draws.weight);
        }
        let capitals = plan.bets.map(|bets| bets.on(&self.draws.weight)).unwrap_or_default();
        let rows = self.draws.rows as u64;
        BlockSums { block, rows, mean, lookups: 0, capitals, channels: self.channels(plan), seconds, early }
    }

    fn count(&mut self, plan: &Plan, first: bool) {
        let Self { draws, index, counts, .. } = self;
        if let (Some(law), Some(cells)) = (&plan.law, &mut counts.cells) {
            cells.observe(&law.truth, &draws.t, index);
            if let Some(ends) = &mut counts.ends {
                ends.observe(&draws.t);
            }
            if let Some(scores) = &law.scores {
                counts.lag.observe(scores, index);
            }
            counts.joint.marks(law, draws, index);
            if law.pair.is_some() {
                counts.ties.observe(&draws.t, first);
            }
            let weighted = draws.weight.iter().filter(|weight| weight.to_bits() != 1f64.to_bits());
            counts.weighted += weighted.count() as u64;
        } else if let Some(channels) = &plan.channels {
            let inside = |t: f64| (t >= 0.0 && t <= channels.length) || t == f64::INFINITY;
            let count = |stray: &dyn Fn(f64) -> bool| draws.t.iter().filter(|&&t| stray(t)).count() as u64;
            counts.strays[0] += count(&f64::is_nan);
            counts.strays[1] += count(&|t| !t.is_nan() && !inside(t));
        }
        if let Some(collisions) = &mut counts.collisions {
            collisions.observe(&draws.collisions, index);
        }
    }

    /// Sums over the first 64, 128, .. draws, so that the running mean begins early.
    fn early(&self, plan: &Plan) -> Vec<PowerSums> {
        let Some(mean) = &plan.mean else { return Vec::new() };
        let counts = (0..64).map(|i| (64.0 * libm::pow(1.09, f64::from(i))) as usize);
        let part = |n: usize| PowerSums::of(mean.truth.expected, &self.draws.weight[..n]);
        counts.take_while(|&n| n < self.draws.weight.len()).map(part).collect()
    }

    fn channels(&mut self, plan: &Plan) -> Vec<PowerSums> {
        let Some(channels) = &plan.channels else {
            return Vec::new();
        };
        let Self { draws, masked, counts, .. } = self;
        let mut one = |(claim, tail): (&crate::plan::ChannelClaim, &mut Option<Tail>)| {
            let column = &draws.channels[claim.channel];
            masked.clear();
            masked.extend(column.iter().zip(&draws.t).map(|(&w, &t)| {
                let counts = claim.event.holds(t) || t.is_nan();
                if counts { w } else { 0.0 }
            }));
            tail.iter_mut().for_each(|tail| tail.observe(masked));
            PowerSums::of(claim.mean.expected, masked)
        };
        channels.claims.iter().zip(&mut counts.tails).map(&mut one).collect()
    }
}

impl Counts {
    fn merge(&mut self, other: Self) {
        if let (Some(a), Some(b)) = (&mut self.cells, &other.cells) {
            a.merge(b);
        }
        if let (Some(a), Some(b)) = (&mut self.ends, &other.ends) {
            a.merge(b);
        }
        if let (Some(a), Some(b)) = (&mut self.collisions, &other.collisions) {
            a.merge(b);
        }
        self.joint.merge(&other.joint);
        self.lag.merge(&other.lag);
        self.ties.merge(other.ties);
        self.weighted += other.weighted;
        self.strays.iter_mut().zip(other.strays).for_each(|(all, more)| *all += more);
        self.lookups.merge(&other.lookups);
        self.audit = self.audit.plus(other.audit);
        for (a, b) in self.tails.iter_mut().zip(&other.tails) {
            if let (Some(a), Some(b)) = (a, b) {
                a.merge(b);
            }
        }
    }
}

impl Collected {
    fn new(plan: &Plan) -> Self {
        let sums = |claim: &crate::plan::ChannelClaim| PowerSums::new(claim.mean.expected);
        Self {
            counts: Counts::default(),
            mean: plan.mean.as_ref().map(|mean| PowerSums::new(mean.truth.expected)),
            running: Running::default(),
            batches: Batches::default(),
            capitals: Capitals::default(),
            channels: plan.channels.iter().flat_map(|channels| channels.claims.iter().map(sums)).collect(),
            draws: 0,
            seconds: 0.0,
        }
    }

    /// Takes in the next block, in block order.
    fn fold(&mut self, block: &BlockSums) {
        block.early.iter().for_each(|early| self.running.note(early));
        if let (Some(a), Some(b)) = (&mut self.mean, &block.mean) {
            a.merge(b);
            self.running.note(a);
            let (n, [sum, squares, ..], lookups) = (b.n as f64, b.sums, block.lookups as f64);
            self.batches.observe(Batch { n, sum, squares, lookups });
        }
        self.capitals.merge(&block.capitals);
        for (weights, w) in self.channels.iter_mut().zip(&block.channels) {
            weights.merge(w);
        }
        self.draws += block.rows;
        self.seconds += block.seconds;
    }

    /// Takes in later draws; the running mean and the batches stay as they are.
    pub fn merge(&mut self, next: Self) {
        if let (Some(a), Some(b)) = (&mut self.mean, &next.mean) {
            a.merge(b);
        }
        self.capitals.merge(&next.capitals);
        for (weights, w) in self.channels.iter_mut().zip(&next.channels) {
            weights.merge(w);
        }
        self.counts.merge(next.counts);
        self.draws += next.draws;
        self.seconds += next.seconds;
        self.fit_tails();
    }

    /// Notes the Pareto shape of each column whose tail was kept.
    fn fit_tails(&mut self) {
        let Self { counts, mean, channels, .. } = self;
        let columns = mean.iter_mut().chain(channels.iter_mut());
        for (sums, tail) in columns.zip(&counts.tails) {
            sums.shape = tail.as_ref().and_then(|tail| tail.shape(sums.n));
        }
    }
}

/// What a run tells while it goes on, and whether it is to stop.
pub struct Watch<'a> {
    /// Set to cancel.
    pub cancelled: &'a AtomicBool,
    /// Called with the number of draws of each finished wave.
    pub progress: &'a (dyn Fn(u64) + Sync),
}

/// A worker for each thread of the pool and one for a thread outside it, made when it is first wanted.
struct Workers(Vec<Mutex<Option<Worker>>>);

impl Workers {
    fn new() -> Self {
        let slots = rayon::current_num_threads() + 1;
        Self((0..slots).map(|_| Mutex::new(None)).collect())
    }

    fn run(&self, subject: &Subject, plan: &Plan, key: Key, nth: u64) -> Result<BlockSums, String> {
        self.with(subject, plan, |worker| worker.run(subject, plan, key, nth))
    }

    /// Puts the worker of this thread to `work`.
    fn with<T>(&self, subject: &Subject, plan: &Plan, work: impl FnOnce(&mut Worker) -> T) -> T {
        let slot = &self.0[rayon::current_thread_index().map_or(0, |i| i + 1)];
        let mut slot = slot.lock().unwrap_or_else(PoisonError::into_inner);
        work(slot.get_or_insert_with(|| Worker::new(subject, plan)))
    }

    /// The counts of all workers; none if nobody worked.
    fn counts(self) -> Option<Counts> {
        let slots = self.0.into_iter();
        let workers = slots.filter_map(|slot| slot.into_inner().unwrap_or_else(PoisonError::into_inner));
        workers.map(|worker| worker.counts).reduce(|mut all, part| {
            all.merge(part);
            all
        })
    }
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

use super::{Counts, FIRST_BLOCKS, Joint};
use crate::plan::{ChannelClaim, Plan};
use crate::sample::{columns, sample_block};
use crate::subject::{BLOCK, Subject};
use freepath_draws::{Draws, Key, MissingColumn, column};
use freepath_statistics::sequence::Capitals;
use freepath_statistics::tally::{CellTally, CountTally, Extremes, PowerSums, Tail};
use std::sync::{Mutex, PoisonError};

/// The float sums of one block.
pub(super) struct BlockSums {
    /// The block's number.
    pub(super) block: u64,
    pub(super) rows: u64,
    pub(super) mean: Option<PowerSums>,
    /// None of draws that come from a file.
    pub(super) lookups: u64,
    pub(super) capitals: Capitals,
    pub(super) channels: Vec<PowerSums>,
    pub(super) seconds: f64,
    /// For the first block: sums over its first draws.
    pub(super) early: Vec<PowerSums>,
}

/// A worker's buffers and counts.
pub(super) struct Worker {
    pub(super) draws: Draws,
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
        let sums = self.tally(plan, key.block, first, record.seconds).map_err(|missing| missing.to_string())?;
        self.counts.joint.watched(watch, &self.index);
        Ok(BlockSums { lookups: record.audit.lookups, ..sums })
    }

    /// Folds the draws of `block`, which took so many seconds.
    pub(super) fn tally(
        &mut self,
        plan: &Plan,
        block: u64,
        first: bool,
        seconds: f64,
    ) -> Result<BlockSums, MissingColumn> {
        self.count(plan, first)?;
        let early = if block == 0 { self.early(plan)? } else { Vec::new() };
        let (mut sums, mut capitals) = (None, Capitals::default());
        if let Some(mean) = &plan.mean {
            let weight = self.draws.f64(column::WEIGHT)?;
            sums = Some(PowerSums::of(mean.truth.expected, weight));
            if let Some(Some(tail)) = self.counts.tails.first_mut() {
                tail.observe(weight);
            }
        }
        if let Some(bets) = plan.bets {
            capitals = bets.on(self.draws.f64(column::WEIGHT)?);
        }
        let (rows, channels) = (self.draws.rows() as u64, self.channels(plan)?);
        Ok(BlockSums { block, rows, mean: sums, lookups: 0, capitals, channels, seconds, early })
    }

    fn count(&mut self, plan: &Plan, first: bool) -> Result<(), MissingColumn> {
        let Self { draws, index, counts, .. } = self;
        if let (Some(law), Some(cells)) = (&plan.law, &mut counts.cells) {
            let t = draws.f64(column::T)?;
            cells.observe(&law.truth, t, index);
            if let Some(ends) = &mut counts.ends {
                ends.observe(t);
            }
            if let Some(scores) = &law.scores {
                counts.lag.observe(scores, index);
            }
            counts.joint.marks(law, draws, index)?;
            if law.pair.is_some() {
                counts.ties.observe(t, first);
            }
            if draws.row().has(column::WEIGHT) {
                let weights = draws.f64(column::WEIGHT)?.iter();
                counts.weighted += weights.filter(|weight| weight.to_bits() != 1f64.to_bits()).count() as u64;
            }
        } else if let Some(channels) = &plan.channels {
            let inside = |t: f64| (t >= 0.0 && t <= channels.length) || t == f64::INFINITY;
            let t = draws.f64(column::T)?;
            let count = |stray: &dyn Fn(f64) -> bool| t.iter().filter(|&&t| stray(t)).count() as u64;
            counts.strays[0] += count(&f64::is_nan);
            counts.strays[1] += count(&|t| !t.is_nan() && !inside(t));
        }
        if let Some(collisions) = &mut counts.collisions {
            collisions.observe(draws.u32(column::COLLISIONS)?, index);
        }
        Ok(())
    }

    /// Sums over the first 64, 128, .. draws, so that the running mean begins early.
    fn early(&self, plan: &Plan) -> Result<Vec<PowerSums>, MissingColumn> {
        let Some(mean) = &plan.mean else { return Ok(Vec::new()) };
        let weight = self.draws.f64(column::WEIGHT)?;
        let counts = (0..64).map(|i| (64.0 * libm::pow(1.09, f64::from(i))) as usize);
        let part = |n: usize| PowerSums::of(mean.truth.expected, &weight[..n]);
        Ok(counts.take_while(|&n| n < weight.len()).map(part).collect())
    }

    fn channels(&mut self, plan: &Plan) -> Result<Vec<PowerSums>, MissingColumn> {
        let Some(channels) = &plan.channels else {
            return Ok(Vec::new());
        };
        let Self { draws, masked, counts, .. } = self;
        let (t, columns) = (draws.f64(column::T)?, draws.channels()?);
        let mut one = |(claim, tail): (&ChannelClaim, &mut Option<Tail>)| {
            let column = columns[claim.channel];
            masked.clear();
            masked.extend(column.iter().zip(t).map(|(&w, &t)| {
                let counts = claim.event.holds(t) || t.is_nan();
                if counts { w } else { 0.0 }
            }));
            tail.iter_mut().for_each(|tail| tail.observe(masked));
            PowerSums::of(claim.mean.expected, masked)
        };
        Ok(channels.claims.iter().zip(&mut counts.tails).map(&mut one).collect())
    }
}

/// A worker for each thread of the pool and one for a thread outside it, made when it is first wanted.
pub(super) struct Workers(Vec<Mutex<Option<Worker>>>);

impl Workers {
    pub(super) fn new() -> Self {
        let slots = rayon::current_num_threads() + 1;
        Self((0..slots).map(|_| Mutex::new(None)).collect())
    }

    pub(super) fn run(&self, subject: &Subject, plan: &Plan, key: Key, nth: u64) -> Result<BlockSums, String> {
        self.with(subject, plan, |worker| worker.run(subject, plan, key, nth))
    }

    /// Puts the worker of this thread to `work`.
    pub(super) fn with<T>(&self, subject: &Subject, plan: &Plan, work: impl FnOnce(&mut Worker) -> T) -> T {
        let slot = &self.0[rayon::current_thread_index().map_or(0, |i| i + 1)];
        let mut slot = slot.lock().unwrap_or_else(PoisonError::into_inner);
        work(slot.get_or_insert_with(|| Worker::new(subject, plan)))
    }

    /// The counts of all workers; none if nobody worked.
    pub(super) fn counts(self) -> Option<Counts> {
        let slots = self.0.into_iter();
        let workers = slots.filter_map(|slot| slot.into_inner().unwrap_or_else(PoisonError::into_inner));
        workers.map(|worker| worker.counts).reduce(|mut all, part| {
            all.merge(part);
            all
        })
    }
}

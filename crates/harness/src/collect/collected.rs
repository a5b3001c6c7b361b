use super::Counts;
use super::worker::BlockSums;
use crate::plan::{ChannelClaim, Plan};
use freepath_statistics::sequence::Capitals;
use freepath_statistics::tally::{Batch, Batches, PowerSums, Running};

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

impl Collected {
    pub(super) fn new(plan: &Plan) -> Self {
        let sums = |claim: &ChannelClaim| PowerSums::new(claim.mean.expected);
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
    pub(super) fn fold(&mut self, block: &BlockSums) {
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
    pub(super) fn fit_tails(&mut self) {
        let Self { counts, mean, channels, .. } = self;
        let columns = mean.iter_mut().chain(channels.iter_mut());
        for (sums, tail) in columns.zip(&counts.tails) {
            sums.shape = tail.as_ref().and_then(|tail| tail.shape(sums.n));
        }
    }
}

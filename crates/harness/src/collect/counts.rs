use super::Joint;
use crate::audit::Audit;
use freepath_statistics::hypothesis::BlockLookups;
use freepath_statistics::tally::{CellTally, CountTally, Extremes, LagTally, Tail, TieTally};

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

impl Counts {
    pub(super) fn merge(&mut self, other: Self) {
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

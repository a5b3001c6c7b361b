use super::{Claim, Withdrawal, counted};
use crate::check;
use crate::fold::{Cells, FoldId, Tallies};
use crate::judged::Judged;
use crate::law::Law;
use freepath_results::{ClaimResult, Reason};
use std::sync::Arc;

/// No collision lies where there is nothing to collide with.
pub struct Vacuum<'a> {
    /// The law of the collisions.
    pub law: Arc<Law>,
    /// True if mu is 0 from one distance to another.
    pub empty: Box<dyn Fn(f64, f64) -> bool + Send + Sync + 'a>,
    /// The collisions by cell.
    pub cells: FoldId<Cells>,
}

impl Claim for Vacuum<'_> {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new("vacuum", "no collision lies where there is nothing to collide with"))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let count = self.collisions(&tallies.counts(self.cells).cells);
        into.facts.extend(counted(check::VACUUM, count, Reason::OutOfSupport, "collisions lie where mu is 0"));
    }
}

impl Vacuum<'_> {
    /// Collisions in empty cells; none are counted if the law is only known up to something.
    fn collisions(&self, cells: &[u64]) -> u64 {
        if self.law.slack() > 0.0 {
            return 0;
        }
        let empty = |k: usize| self.law.mass(k) <= 0.0 && (self.empty)(self.law.edge(k), self.law.edge(k + 1));
        let hit = cells.iter().enumerate().filter(|(_, count)| **count > 0);
        hit.filter(|(k, _)| empty(*k)).map(|(_, count)| count).sum()
    }
}

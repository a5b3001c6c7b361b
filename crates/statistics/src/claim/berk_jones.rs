use super::law::prefixed;
use super::{Claim, Withdrawal};
use crate::fold::{Cells, Ends, FoldId, Tallies};
use crate::hypothesis;
use crate::judged::Judged;
use crate::law::Law;
use freepath_results::{ClaimResult, Reason};
use std::sync::Arc;

/// The smallest and largest values of a column follow a law, between the edges of its cells as well.
pub struct BerkJonesClaim<'a> {
    /// `own_` for the law that a method has by design.
    pub prefix: &'static str,
    /// The law.
    pub law: Arc<Law>,
    /// P(t > x) at any x.
    pub survival: Box<dyn Fn(f64) -> f64 + Send + Sync + 'a>,
    /// The column by cell.
    pub cells: FoldId<Cells>,
    /// Its ends.
    pub ends: FoldId<Ends>,
    /// Bits of the uniforms.
    pub bits: u32,
    /// The reason that a rejection gives.
    pub reason: Reason,
}

impl Claim for BerkJonesClaim<'_> {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new(
            format!("{}berk_jones", self.prefix),
            "the smallest and largest draws follow the law, between the edges of its cells as well",
        ))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let (cells, ends) = (tallies.counts(self.cells), tallies.counts(self.ends));
        let evidence = hypothesis::berk_jones((&self.law, &*self.survival), cells, ends, self.bits, self.reason);
        into.evidence.push(prefixed(self.prefix, evidence));
    }
}

use super::{Claim, Withdrawal};
use crate::fold::{Collisions, FoldId, Tallies};
use crate::hypothesis;
use crate::judged::Judged;
use crate::law::Law;
use freepath_results::{ClaimResult, Reason};
use std::sync::Arc;

/// Tentative collisions and distance follow Coleman's joint law (Coleman 1968).
pub struct ColemanClaim<'a> {
    /// The law of the distance.
    pub law: Arc<Law>,
    /// The integral of mu_bar - mu up to a distance.
    pub null_depth: Box<dyn Fn(f64) -> f64 + Send + Sync + 'a>,
    /// Collisions by group of distance.
    pub collisions: FoldId<Collisions>,
}

impl Claim for ColemanClaim<'_> {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new("coleman", "tentative collisions and distance follow Coleman’s joint law"))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::Lookups, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let counts = tallies.counts(self.collisions);
        into.evidence.push(hypothesis::coleman(&self.law, counts, &self.null_depth, Reason::WrongLaw));
    }
}

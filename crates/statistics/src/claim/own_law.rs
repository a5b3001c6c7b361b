use super::law::follows;
use super::{Claim, Withdrawal};
use crate::fold::{Cells, FoldId, Tallies};
use crate::judged::Judged;
use crate::law::Law;
use freepath_results::{ClaimResult, Reason};
use std::sync::Arc;

/// A column follows the law that its method has by design: so "biased" and "buggy" stay apart.
pub struct OwnLaw {
    /// That law.
    pub law: Arc<Law>,
    /// The column by cell.
    pub cells: FoldId<Cells>,
}

impl Claim for OwnLaw {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new("own_law", "the draws follow the law that their method has by design"))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        follows("own_", &self.law, tallies.counts(self.cells), Reason::WrongLaw, into);
    }
}

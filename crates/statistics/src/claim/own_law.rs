use super::law::{follows, prefixed};
use super::{Claim, Withdrawal};
use crate::fold::{Cells, FoldId, Tallies};
use crate::hypothesis;
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
    /// True if it has no atoms on the ray: one at the edge of a cell would be counted on either side.
    pub continuous: bool,
}

impl Claim for OwnLaw {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new("own_law", "the draws follow the law that their method has by design"))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let cells = tallies.counts(self.cells);
        follows("own_", &self.law, cells, Reason::WrongLaw, into);
        if self.continuous {
            into.evidence.push(prefixed("own_", hypothesis::scan(&self.law, cells, Reason::WrongLaw)));
        }
    }
}

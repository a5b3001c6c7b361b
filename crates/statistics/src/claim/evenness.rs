use super::law::{fine_cells, prefixed};
use super::{Claim, Withdrawal};
use crate::fold::{Cells, FoldId, Tallies};
use crate::hypothesis;
use crate::judged::Judged;
use crate::law::Law;
use freepath_results::ClaimResult;
use std::sync::Arc;

/// Counts in cells scatter as those of independent draws do, and no less.
pub struct Evenness {
    /// `joint_` for both ranks of a row at once.
    pub prefix: &'static str,
    /// A law that the draws follow.
    pub law: Arc<Law>,
    /// The column by cell.
    pub cells: FoldId<Cells>,
}

impl Claim for Evenness {
    fn statement(&self) -> Option<ClaimResult> {
        let name = format!("{}scatter", self.prefix);
        Some(ClaimResult::new(name, "counts in cells scatter as those of independent draws do"))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let cells = tallies.counts(self.cells);
        let fine = fine_cells(cells.draws());
        let evidence = hypothesis::too_even(&self.law, cells, if fine > 64 { fine } else { 64 });
        into.evidence.push(prefixed(self.prefix, evidence));
    }
}

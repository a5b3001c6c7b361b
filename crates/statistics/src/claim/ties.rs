use super::{Claim, Withdrawal};
use crate::fold::{Cells, FoldId, Tallies, Ties};
use crate::hypothesis;
use crate::judged::Judged;
use freepath_results::ClaimResult;

/// Values of a column tie no more often than the resolution of its uniforms makes them.
pub struct TiesClaim {
    /// The probability that two draws tie.
    pub pair: f64,
    /// The ties.
    pub ties: FoldId<Ties>,
    /// The column by cell.
    pub cells: FoldId<Cells>,
    /// True if the rows were written by another program, which may have rounded them.
    pub written: bool,
}

/// The reason why samples tie, as often as not.
const FEW_DIGITS: &str =
    "numbers printed with few digits repeat: print 17, or state `resolution_bits` and `tolerance`";

impl Claim for TiesClaim {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new("ties", "draws tie no more often than the resolution of their uniforms makes them"))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let collided = tallies.counts(self.cells).collided();
        let ties = hypothesis::ties(tallies.counts(self.ties), collided, self.pair);
        let rounded = self.written && ties.statistic > 0.0;
        into.evidence.push(if rounded { ties.noted(FEW_DIGITS) } else { ties });
    }
}

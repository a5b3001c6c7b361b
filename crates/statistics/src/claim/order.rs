use super::law::prefixed;
use super::{Claim, Withdrawal};
use crate::fold::{Cells, FoldId, Lags, RankedColumn, Tallies};
use crate::hypothesis;
use crate::judged::Judged;
use crate::tally::{Circular, Scores, Sequence};
use freepath_results::ClaimResult;
use std::sync::Arc;

/// Draws are independent of one another and alike along the run, in ranks under a law that they follow.
pub struct Order {
    /// The rank of each cell.
    pub scores: Arc<Scores>,
    /// Products and tables of neighbours.
    pub lags: FoldId<Lags>,
    /// The column by cell.
    pub cells: FoldId<Cells>,
}

impl Claim for Order {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new(
            "independent",
            "draws are independent of one another, near and far, and alike along the run",
        ))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let (lags, cells) = (tallies.counts(self.lags), tallies.counts(self.cells));
        into.evidence.push(hypothesis::lag(&self.scores, lags, cells));
        into.evidence.push(hypothesis::lags(&self.scores, lags, cells));
        into.evidence.push(hypothesis::pairs(lags));
        judge_order(tallies.sums(self.lags), RareRows::of(&self.scores), into);
    }
}

/// Draws are uncorrelated and alike along the run, whatever their law: ranks only say what is multiplied.
pub struct ObservedOrder {
    /// The rank of each cell.
    pub scores: Arc<Scores>,
    /// Products of neighbours.
    pub lags: FoldId<Lags>,
    /// The column by cell.
    pub cells: FoldId<Cells>,
}

impl Claim for ObservedOrder {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new(
            "uncorrelated",
            "draws are uncorrelated and alike along the run, whatever their law",
        ))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let (lags, cells) = (tallies.counts(self.lags), tallies.counts(self.cells));
        into.evidence.push(hypothesis::lag(&self.scores, lags, cells));
        judge_order(tallies.sums(self.lags), RareRows::of(&self.scores), into);
    }
}

/// The rows of a column whose law is not known are independent of one another and alike along the run.
pub struct ColumnOrder {
    /// The words before the names of its tests, if others of the subject have the same.
    pub prefix: String,
    /// The column's order.
    pub column: FoldId<RankedColumn>,
    /// True if infinite rows are escapes.
    pub escapes: bool,
}

impl Claim for ColumnOrder {
    fn statement(&self) -> Option<ClaimResult> {
        let words = "rows are independent of one another, near and far, and alike along the run";
        Some(ClaimResult::new(format!("{}independent", self.prefix), words))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let mut judged = Judged::default();
        let rare = if self.escapes { RareRows::Escapes } else { RareRows::Uncommon };
        judge_order(tallies.sums(self.column), rare, &mut judged);
        into.evidence.extend(judged.evidence.into_iter().map(|evidence| prefixed(&self.prefix, evidence)));
    }
}

/// The rows of a column that may be rare.
#[derive(Clone, Copy, PartialEq, Eq)]
enum RareRows {
    /// None: the law is continuous.
    None,
    /// Escapes, or collisions.
    Escapes,
    /// Those that differ from the commonest value.
    Uncommon,
}

impl RareRows {
    fn of(scores: &Scores) -> Self {
        if scores.has_escapes() { Self::Escapes } else { Self::None }
    }
}

/// The tests of order, all of which are planned before a row is drawn.
fn judge_order(sequence: &Sequence, rare: RareRows, into: &mut Judged) {
    let first = sequence.first();
    let circular = first.as_ref().map(|first| Circular::of(&first.scores));
    into.evidence.push(hypothesis::order(circular.as_ref()));
    if rare != RareRows::None {
        into.evidence.push(hypothesis::rare_lags(first.as_ref()));
    }
    into.evidence.push(hypothesis::period(circular.as_ref()));
    into.evidence.push(hypothesis::pairs_far(first.as_ref()));
    into.evidence.push(hypothesis::triples(first.as_ref()));
    into.evidence.push(hypothesis::batches(sequence));
    into.evidence.push(hypothesis::along(sequence));
    if rare == RareRows::Escapes {
        into.evidence.push(hypothesis::along_escapes(sequence));
    }
}

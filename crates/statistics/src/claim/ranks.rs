use super::law::{fine_cells, prefixed};
use super::{Claim, Withdrawal};
use crate::fold::{Cells, FoldId, Tallies};
use crate::hypothesis;
use crate::judged::Judged;
use crate::law::Law;
use freepath_results::{ClaimResult, Reason};
use std::sync::Arc;

/// A claim about the second rank of a row, whose distribution function is that given the first (Rosenblatt 1952). Its tests have names
/// of their own.
pub struct SecondRank<C>(pub C);

impl<C: Claim> Claim for SecondRank<C> {
    fn statement(&self) -> Option<ClaimResult> {
        let ClaimResult { name, statement } = self.0.statement()?;
        Some(ClaimResult::new(
            format!("second_rank_{name}"),
            format!("of the second rank, given the first: {statement}"),
        ))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        self.0.withdrawn_by()
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let mut judged = Judged::default();
        self.0.judge(tallies, &mut judged);
        into.evidence.extend(judged.evidence.into_iter().map(|evidence| prefixed("second_rank_", evidence)));
        into.facts.extend(judged.facts);
        into.gates.extend(judged.gates);
    }
}

/// The two ranks of a row are uniform on the square, and so independent: one number made of both, such as [`joint_rank`], is uniform.
pub struct JointRanks {
    /// The uniform law.
    pub law: Arc<Law>,
    /// The joint rank by cell.
    pub cells: FoldId<Cells>,
    /// The reason that a rejection gives.
    pub reason: Reason,
    /// What is claimed, in words.
    pub words: &'static str,
}

/// Strips of the first rank.
const STRIPS: f64 = 16.0;

/// One number for two ranks: the strip of the first, and inside it the second. It is uniform if the two are uniform and
/// independent, and its cells are those of a table.
#[must_use]
pub fn joint_rank(first: f64, second: f64) -> f64 {
    let strip = (STRIPS * first).floor();
    let strip = if strip >= STRIPS { STRIPS - 1.0 } else { strip };
    (strip + second) / STRIPS
}

impl Claim for JointRanks {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new("joint_ranks", self.words))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let cells = tallies.counts(self.cells);
        let fine = fine_cells(cells.draws());
        for (name, wanted) in [("chi_square_64", 64), ("chi_square_fine", fine)] {
            let evidence = hypothesis::chi_square(name, &self.law, cells, wanted, self.reason);
            into.evidence.push(prefixed("joint_", evidence));
        }
        into.evidence.push(prefixed("joint_", hypothesis::scan(&self.law, cells, self.reason)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_strip_of_the_first_holds_the_second() {
        let ranks = [joint_rank(0.0, 0.5), joint_rank(0.99, 0.25), joint_rank(1.0, 1.0)];
        assert_eq!(ranks.map(|rank| (rank * 64.0) as u32), [2, 61, 64]);
        assert!(
            joint_rank(-1.0, 0.5) < 0.0
                && joint_rank(f64::NAN, 0.5).is_nan()
                && joint_rank(0.5, f64::NAN).is_nan()
        );
    }
}

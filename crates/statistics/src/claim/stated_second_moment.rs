use super::mean::power_sums;
use super::{Claim, Withdrawal};
use crate::fold::{FoldId, Tallies, Weights};
use crate::hypothesis;
use crate::judged::Judged;
use freepath_results::ClaimResult;

/// A column of stated range has the second moment that its author states.
pub struct StatedSecondMoment {
    /// The column's sums.
    pub weights: FoldId<Weights>,
    /// E[X^2].
    pub expected: f64,
    /// Least and greatest value.
    pub range: (f64, f64),
    /// How far each draw may be off.
    pub slack: f64,
}

impl Claim for StatedSecondMoment {
    fn statement(&self) -> Option<ClaimResult> {
        let words = format!("the second moment is {:.4e}, as declared", self.expected);
        Some(ClaimResult::new("stated_second_moment", words))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::SecondMoment, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let sums = power_sums(tallies, self.weights);
        into.evidence.push(hypothesis::stated_second_moment(&sums, self.expected, self.range, self.slack));
    }
}

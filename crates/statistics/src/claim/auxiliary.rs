use super::{Claim, Withdrawal, counted};
use crate::check;
use crate::fold::{Auxiliary, FoldId, Tallies};
use crate::hypothesis;
use crate::judged::Judged;
use freepath_results::{ClaimResult, Reason};

/// A number that comes with each draw is uniform on [0, 1) and independent of it.
pub struct AuxiliaryClaim {
    /// The numbers by group of distance.
    pub numbers: FoldId<Auxiliary>,
}

impl Claim for AuxiliaryClaim {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new(
            "auxiliary",
            "a number that comes with each draw is uniform on [0, 1) and independent of it",
        ))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let numbers = tallies.counts(self.numbers);
        let what = "auxiliary numbers do not lie in [0, 1)";
        into.facts.extend(counted(check::FINITE, numbers.spoilt, Reason::NonFinite, what));
        into.evidence.push(hypothesis::auxiliary(numbers));
    }
}

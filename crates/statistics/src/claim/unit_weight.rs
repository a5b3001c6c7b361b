use super::{Claim, Finding, Withdrawal, counted};
use crate::check;
use crate::fold::{FoldId, Tallies, UnitWeight};
use crate::judged::Judged;
use freepath_draws::Draws;
use freepath_results::{ClaimResult, Reason};

/// Every draw has the weight 1: the tests of a law count draws, and a weight would make them mean something else.
pub struct UnitWeightClaim {
    /// The column.
    pub column: &'static str,
    /// Other weights.
    pub other: FoldId<UnitWeight>,
}

impl Claim for UnitWeightClaim {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new("unit_weight", "every draw has the weight 1"))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let (other, what) = (*tallies.counts(self.other), "draws have a weight other than 1");
        into.facts.extend(counted(check::UNIT_WEIGHT, other, Reason::WrongLaw, what));
    }

    fn look(&self, draws: &Draws, row: usize) -> Option<Finding> {
        finite(draws.f64(self.column).ok()?[row])
    }
}

/// A weight is a number.
pub(super) fn finite(weight: f64) -> Option<Finding> {
    let what = || format!("a weight is {weight}");
    (!weight.is_finite()).then(|| Finding { reason: Reason::NonFinite, what: what() })
}

use super::{Claim, Withdrawal};
use crate::fold::{FoldId, Nulls, Tallies};
use crate::hypothesis;
use crate::judged::Judged;
use freepath_results::ClaimResult;

/// Along the ray, the share mu / mu_bar of the tentative collisions is real.
pub struct NullPositionsClaim {
    /// Tentative and real collisions.
    pub nulls: FoldId<Nulls>,
}

impl Claim for NullPositionsClaim {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new(
            "null_positions",
            "along the ray, the share mu / mu_bar of the tentative collisions is real",
        ))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::Lookups, Withdrawal::Bounded, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        into.evidence.push(hypothesis::null_positions(tallies.counts(self.nulls)));
    }
}

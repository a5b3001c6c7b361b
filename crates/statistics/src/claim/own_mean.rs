use super::mean::power_sums;
use super::{Claim, Withdrawal};
use crate::fold::{FoldId, Tallies, Weights};
use crate::hypothesis::{self, MeanClaim};
use crate::judged::Judged;
use freepath_results::{ClaimResult, Reason};

/// A column has the mean that its method has by design: so "biased" and "buggy" stay apart.
pub struct OwnMean {
    /// The column's sums.
    pub weights: FoldId<Weights>,
    /// That mean.
    pub mean: MeanClaim,
}

impl Claim for OwnMean {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new(
            "own_mean",
            format!("the mean of the draws is {:.4e}, as their method has it by design", self.mean.expected),
        ))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let sums = power_sums(tallies, self.weights);
        into.evidence.push(hypothesis::mean("own_mean", &sums, &self.mean, Reason::WrongLaw).0);
    }
}

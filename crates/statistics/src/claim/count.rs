use super::{Claim, Withdrawal};
use crate::fold::{Collisions, FoldId, Tallies};
use crate::hypothesis;
use crate::judged::Judged;
use freepath_results::ClaimResult;

/// An integer column is Poisson.
pub struct PoissonClaim {
    /// Its mean.
    pub mean: f64,
    /// Its counts.
    pub counts: FoldId<Collisions>,
    /// The most by which the mean may be off.
    pub slack: f64,
}

impl Claim for PoissonClaim {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new(
            "poisson_count",
            format!("the collisions of a draw are Poisson with the mean {:.4e}", self.mean),
        ))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::Lookups, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        into.evidence.push(hypothesis::poisson_count(tallies.counts(self.counts), self.mean, self.slack));
    }
}

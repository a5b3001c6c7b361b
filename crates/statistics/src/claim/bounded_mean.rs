use super::mean::power_sums;
use super::{Claim, Moments, Withdrawal};
use crate::fold::{FoldId, Tallies, WealthSums};
use crate::hypothesis::{self, MeanClaim};
use crate::judged::Judged;
use crate::sequence::Portfolio;
use freepath_results::{ClaimResult, Reason};

/// A column of stated range has this mean, whatever its law.
pub struct BoundedMean {
    /// The name of the test.
    pub name: String,
    /// The sums.
    pub sums: Moments,
    /// Bets on its rows, where no formula gives their variance.
    pub wealth: Option<FoldId<WealthSums>>,
    /// The mean, and the range.
    pub mean: MeanClaim,
    /// The reason that a rejection gives.
    pub reason: Reason,
}

/// The bets that the test of a mean needs: none without a range, on 0/1 draws, or where a formula gives the variance.
#[must_use]
pub fn portfolio(mean: &MeanClaim) -> Option<Portfolio> {
    let MeanClaim { expected, slack, range, .. } = *mean;
    Some(Portfolio::new(expected, slack, range?)).filter(|_| bounds(mean) && mean.variance.is_none())
}

/// True if a mean has a test by its range.
#[must_use]
pub fn bounds(mean: &MeanClaim) -> bool {
    mean.range.is_some() && !mean.binary
}

impl Claim for BoundedMean {
    fn statement(&self) -> Option<ClaimResult> {
        let (low, high) = self.mean.range?;
        let words = format!(
            "whatever law in [{low:.4e}, {high:.4e}] the draws have, their mean is {:.4e}",
            self.mean.expected
        );
        Some(ClaimResult::new(self.name.clone(), words))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let sums = match self.sums {
            Moments::Column(weights) => power_sums(tallies, weights),
            Moments::Event(event) => super::event::power_sums(tallies, event),
        };
        let wealth = self.wealth.map(|wealth| tallies.sums(wealth));
        into.evidence.extend(hypothesis::bounded_mean(&self.name, &sums, wealth, &self.mean, self.reason));
    }
}

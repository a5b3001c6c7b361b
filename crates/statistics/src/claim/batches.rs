use super::mean::{power_sums, with_interval};
use super::{Claim, Moments, Summary, Withdrawal};
use crate::fold::{Batched, FoldId, Tallies};
use crate::hypothesis::{self, MeanClaim};
use crate::judged::Judged;
use crate::law::Law;
use crate::tally::PowerSums;
use freepath_results::{ClaimResult, Reason};
use std::sync::Arc;

/// A column has this mean, whether or not its rows depend on one another: in place of the tests that need independent rows.
pub struct BatchMean {
    /// The name of the test.
    pub name: String,
    /// The sums.
    pub sums: Moments,
    /// The same over batches of neighbouring rows.
    pub batches: FoldId<Batched>,
    /// The mean, and what is known of its draws.
    pub mean: MeanClaim,
    /// The reason that a rejection gives.
    pub reason: Reason,
    /// True if it is the mean of the results.
    pub told: bool,
}

impl BatchMean {
    fn sums(&self, tallies: &Tallies) -> PowerSums {
        match self.sums {
            Moments::Column(weights) => power_sums(tallies, weights),
            Moments::Event(event) => super::event::power_sums(tallies, event),
        }
    }
}

impl Claim for BatchMean {
    fn statement(&self) -> Option<ClaimResult> {
        let words =
            format!("the mean of the draws, which may depend on one another, is {:.4e}", self.mean.expected);
        Some(ClaimResult::new(self.name.clone(), words))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let (sums, batches) = (self.sums(tallies), tallies.sums(self.batches));
        let (evidence, _, open) = hypothesis::batch_mean(&self.name, &sums, batches, &self.mean, self.reason);
        into.gates.extend(open.map(|(reason, why)| (reason, format!("{}: {why}", self.name))));
        into.evidence.push(evidence);
    }

    fn summarize(&self, tallies: &Tallies, into: &mut Summary) {
        if self.told {
            let (sums, batches) = (self.sums(tallies), tallies.sums(self.batches));
            let (_, interval, _) = hypothesis::batch_mean(&self.name, &sums, batches, &self.mean, self.reason);
            let detectable =
                hypothesis::detectable_batch_mean(&interval, &sums, batches, &self.mean, &into.detection);
            into.mean = Some(with_interval(&self.mean, &sums, &interval, detectable));
        }
    }
}

/// A column follows a law, whether or not its rows depend on one another.
pub struct BatchShares {
    /// The law.
    pub law: Arc<Law>,
    /// The shares of its cells over batches of neighbouring rows.
    pub batches: FoldId<Batched>,
    /// The reason that a rejection gives.
    pub reason: Reason,
}

impl Claim for BatchShares {
    fn statement(&self) -> Option<ClaimResult> {
        let words = "the draws, which may depend on one another, follow the law of the scene";
        Some(ClaimResult::new("batch_shares", words))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let batches = tallies.sums(self.batches);
        let evidence = hypothesis::batch_shares(&self.law, batches, tallies.draws, self.reason);
        let open = || (Reason::NotEnoughDraws, format!("batch_shares: {}", evidence.note));
        into.gates.extend(evidence.p.is_none().then(open));
        into.evidence.push(evidence);
    }
}

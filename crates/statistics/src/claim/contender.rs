use super::mean::power_sums;
use super::{Claim, Withdrawal};
use crate::fold::{FoldId, Lookups, Tallies, Weights};
use crate::hypothesis::{BlockLookups, MeanClaim};
use crate::tally::{Batches, PowerSums};
use freepath_results::ClaimResult;

/// The data of an estimator that a ranking by efficiency, 1 / (V T), needs.
pub struct Contender<'a> {
    /// The sums of its draws.
    pub sums: PowerSums,
    /// The mean that they should have.
    pub truth: MeanClaim,
    /// The bias of its mean by design.
    pub design_bias: f64,
    /// The kurtosis by formula, where one is known.
    pub kurtosis: Option<f64>,
    /// Look-ups by block.
    pub lookups: &'a BlockLookups,
    /// Variance and cost by groups of blocks.
    pub batches: &'a Batches,
}

/// An estimator whose variance and cost can be compared with those of others.
pub struct EfficiencyClaim {
    /// The sums of its draws.
    pub weights: FoldId<Weights>,
    /// Its look-ups.
    pub lookups: FoldId<Lookups>,
    /// The mean that they should have.
    pub truth: MeanClaim,
    /// The bias of its mean by design.
    pub design_bias: f64,
    /// E[X^k] for k = 1 to 6, by formula.
    pub moments: Option<[f64; 6]>,
}

impl Claim for EfficiencyClaim {
    fn statement(&self) -> Option<ClaimResult> {
        None
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Independent]
    }

    fn contender<'a>(&'a self, tallies: &'a Tallies) -> Option<Contender<'a>> {
        Some(Contender {
            sums: power_sums(tallies, self.weights),
            truth: self.truth,
            design_bias: self.design_bias,
            kurtosis: self.kurtosis(),
            lookups: &tallies.counts(self.lookups).blocks,
            batches: &tallies.sums(self.weights).batches,
        })
    }
}

impl EfficiencyClaim {
    /// The kurtosis by formula, where one is known and cancellation leaves it digits.
    fn kurtosis(&self) -> Option<f64> {
        let pq = self.truth.expected * (1.0 - self.truth.expected);
        if self.truth.binary {
            return Some((1.0 - 3.0 * pq) / pq).filter(|k| k.is_finite());
        }
        let [m1, m2, m3, m4, ..] = self.moments?;
        let variance = m2 - m1 * m1;
        let fourth = m4 - 4.0 * m1 * m3 + 6.0 * m1 * m1 * m2 - 3.0 * m1 * m1 * m1 * m1;
        Some(fourth / (variance * variance)).filter(|_| variance > 1e-6 * m1 * m1)
    }
}

use super::{Claim, Withdrawal};
use crate::check;
use crate::evidence::Fact;
use crate::fold::{FoldId, Tallies, Weights};
use crate::judged::Judged;
use freepath_results::{ClaimResult, Reason};

/// Estimates are all the same: their author states that they have no noise.
pub struct NoiseFree {
    /// The column's sums.
    pub weights: FoldId<Weights>,
    /// The most by which two may be apart.
    pub rounding: f64,
}

impl Claim for NoiseFree {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new("noise_free", "every estimate is the same, as declared"))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let sums = &tallies.sums(self.weights).all;
        let (least, greatest) = (sums.least, sums.greatest);
        let words = || format!("draws go from {least:e} to {greatest:e}, and are declared to have no noise");
        let apart = sums.n > 0 && !(greatest - least <= self.rounding);
        into.facts.extend(apart.then(|| Fact::new(check::NOISE_FREE.name, Reason::WrongVariance, words())));
    }
}

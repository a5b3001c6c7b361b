use super::{Claim, Withdrawal};
use crate::check;
use crate::evidence::Fact;
use crate::fold::{FoldId, Tallies, WeighedRows, WeightIdentity};
use crate::judged::Judged;
use freepath_results::{ClaimResult, Reason};

/// The weights of a row are a known function of its distance.
pub struct WeightIdentityClaim {
    /// The rows of the first blocks.
    pub rows: FoldId<WeightIdentity>,
}

impl Claim for WeightIdentityClaim {
    fn statement(&self) -> Option<ClaimResult> {
        let words = "the weights of a draw are those that its distance has under the balance heuristic";
        Some(ClaimResult::new("weight_identity", words))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let WeighedRows { looked, other } = *tallies.counts(self.rows);
        if other > 0 {
            let words =
                format!("{other} of the first {looked} draws have other weights than belong to their distance");
            into.facts.push(Fact::new(check::WEIGHT_IDENTITY.name, Reason::WrongLaw, words));
        }
    }
}

use super::mean::power_sums;
use super::{Claim, Withdrawal};
use crate::fold::{EventSums, FoldId, Tallies, Weights};
use crate::hypothesis::{self, SecondMoment};
use crate::judged::Judged;
use crate::tally::PowerSums;
use freepath_results::ClaimResult;

/// The sums whose second moment is claimed.
#[derive(Clone, Copy)]
pub enum Moments {
    /// Of a column.
    Column(FoldId<Weights>),
    /// Of a column where an event happens.
    Event(FoldId<EventSums>),
}

/// A column has this second moment.
pub struct SecondMomentClaim {
    /// The name of the test.
    pub name: String,
    /// The sums.
    pub sums: Moments,
    /// What it is.
    pub moment: SecondMoment,
}

impl Claim for SecondMomentClaim {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new(self.name.clone(), format!("the second moment is {:.4e}", self.moment.moments[0])))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::SecondMoment, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let sums: PowerSums = match self.sums {
            Moments::Column(weights) => power_sums(tallies, weights),
            Moments::Event(event) => super::event::power_sums(tallies, event),
        };
        into.evidence.push(hypothesis::second_moment(&self.name, &sums, self.moment));
    }
}

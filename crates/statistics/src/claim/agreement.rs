use super::mean::power_sums;
use super::{Claim, Withdrawal};
use crate::evidence::Evidence;
use crate::fold::{Cells, FoldId, Tallies, Weights};
use crate::hypothesis::{self, Sample};
use crate::tally::{CellTally, PowerSums};
use freepath_results::{ClaimResult, Reason};

/// The quantity that two settings of a subject have in common, and that is compared.
pub enum Comparable<'a> {
    /// A law, by cells, and what a rejection means.
    Law(&'a CellTally, Reason),
    /// A mean, and what is known of its draws.
    Mean(PowerSums, Spread),
}

/// The range of the draws of a mean, as far as it is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// The least and greatest value, if they are known.
    pub range: Option<(f64, f64)>,
    /// Every value is 0 or 1.
    pub binary: bool,
}

/// Two settings that are compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreed {
    /// The name of the test.
    pub name: &'static str,
    /// True if the whole law is the same in both; false if only its atom is.
    pub whole_law: bool,
    /// The most by which the two may be apart.
    pub slack: f64,
}

impl Comparable<'_> {
    /// One two-sample test: of the means, or of the escapes and, where the law is the same, of the distances of the others.
    #[must_use]
    pub fn agree(own: Option<Self>, other: Option<Self>, test: &Agreed) -> Evidence {
        let (name, slack) = (test.name, test.slack);
        match (own, other) {
            (Some(Self::Mean(a, Spread { range, binary })), Some(Self::Mean(b, _))) => {
                hypothesis::agree_mean(name, [&a, &b], &Sample { range, binary, slack })
            }
            (Some(Self::Law(a, reason)), Some(Self::Law(b, _))) if !test.whole_law => {
                hypothesis::agree_atom(name, [a, b], slack, reason)
            }
            (Some(Self::Law(a, reason)), Some(Self::Law(b, _))) if a.cells.len() == b.cells.len() => {
                hypothesis::agree_law(name, [a, b], slack, reason)
            }
            (Some(Self::Mean(..) | Self::Law(..)) | None, _) => {
                Evidence::withheld(name, f64::NAN, Reason::WrongLaw, "there is nothing to compare")
            }
        }
    }
}

/// A column has the same law in two settings, or the same share of escapes.
pub struct LawAgreement {
    /// The column by cell.
    pub cells: FoldId<Cells>,
    /// The reason that a rejection gives.
    pub reason: Reason,
}

impl Claim for LawAgreement {
    fn statement(&self) -> Option<ClaimResult> {
        None
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[]
    }

    fn comparable<'a>(&self, tallies: &'a Tallies) -> Option<Comparable<'a>> {
        Some(Comparable::Law(tallies.counts(self.cells), self.reason))
    }
}

/// A column has the same mean in two settings.
pub struct MeanAgreement {
    /// Its sums.
    pub weights: FoldId<Weights>,
    /// The range of its draws, as far as it is known.
    pub spread: Spread,
}

impl Claim for MeanAgreement {
    fn statement(&self) -> Option<ClaimResult> {
        None
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[]
    }

    fn comparable<'a>(&self, tallies: &'a Tallies) -> Option<Comparable<'a>> {
        Some(Comparable::Mean(power_sums(tallies, self.weights), self.spread))
    }
}

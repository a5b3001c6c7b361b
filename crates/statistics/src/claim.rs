//! Claims: checkable statements about columns of a subject's draws. A claim is a value with everything that belongs to it:
//! the folds it reads, the tests it is put to, what it adds to the results, how it grows towards a bound.
//!
//! Claims are fine, one family of tests each, so that one that a case withdraws is left out of a list and nothing else
//! changes.

pub(crate) use crate::check::counted;
use crate::evidence::Fact;
use crate::fold::{ProbableEscape, Tallies};
use crate::judged::Judged;
use freepath_draws::Draws;
use freepath_results::{ClaimResult, Reason};

mod agreement;
mod auxiliary;
mod batches;
mod berk_jones;
mod binary;
mod bounded;
mod bounded_mean;
mod breaks;
mod claims;
mod coleman;
mod contender;
mod count;
mod count_column;
mod count_law;
mod design;
mod domain;
mod drawing_order;
mod enough_rows;
mod estimates;
mod evenness;
mod event;
mod events;
mod infinite_variance;
mod law;
mod lookups;
mod mean;
mod noise_free;
mod null_positions;
mod order;
mod own_law;
mod own_mean;
mod path;
mod pdf_integral;
mod ranks;
mod remark;
mod second_moment;
mod sequential;
mod series;
mod stated_second_moment;
mod summary;
mod ties;
mod trials;
mod unit_weight;
mod vacuum;
mod weight_identity;
mod weighted_law;
mod withdrawal;

pub use agreement::{Agreed, Comparable, LawAgreement, MeanAgreement, Spread};
pub use auxiliary::AuxiliaryClaim;
pub use batches::{BatchMean, BatchShares};
pub use berk_jones::BerkJonesClaim;
pub use binary::Binary;
pub use bounded::{Bounded, InsideRay};
pub use bounded_mean::{BoundedMean, bounds, portfolio};
pub use breaks::BreaksClaim;
pub use claims::Claims;
pub use coleman::ColemanClaim;
pub use contender::{Contender, EfficiencyClaim};
pub use count::PoissonClaim;
pub use count_column::CountColumn;
pub use count_law::CountLaw;
pub use design::Design;
pub use domain::{AtomsClaim, Domain};
pub use drawing_order::DrawingOrder;
pub use enough_rows::EnoughRows;
pub use estimates::Estimates;
pub use evenness::Evenness;
pub use event::EventClaim;
pub use events::{EventWeights, FiniteRow};
pub use infinite_variance::InfiniteVariance;
pub use law::{LawClaim, band, worst};
pub use lookups::LookupsClaim;
pub use mean::{WeightClaim, bets, power_sums};
pub use noise_free::NoiseFree;
pub use null_positions::NullPositionsClaim;
pub use order::{ColumnOrder, ObservedOrder, Order};
pub use own_law::OwnLaw;
pub use own_mean::OwnMean;
pub use path::{CountedPath, Escaping, Path};
pub use pdf_integral::PdfIntegral;
pub use ranks::{JointRanks, SecondRank, joint_rank};
pub use remark::{Panel, Remark, Shows};
pub use second_moment::{Moments, SecondMomentClaim};
pub use sequential::{Asked, BiasBound, InterimLook, SequentialTest};
pub use series::SeriesClaim;
pub use stated_second_moment::StatedSecondMoment;
pub use summary::{StepOrder, Summary};
pub use ties::{TiesClaim, Written};
pub use trials::Trials;
pub use unit_weight::UnitWeightClaim;
pub use vacuum::Vacuum;
pub use weight_identity::WeightIdentityClaim;
pub use weighted_law::WeightedLawClaim;
pub use withdrawal::Withdrawal;

/// A contradiction of a claim, for certain, by one row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// The reason that it gives.
    pub reason: Reason,
    /// In words.
    pub what: String,
}

/// A checkable statement about columns of draws.
pub trait Claim: Send + Sync {
    /// The claim in words, for the results; none of what only serves a gate, a ranking, or a comparison with another setting.
    fn statement(&self) -> Option<ClaimResult>;

    /// The withdrawals that take this claim back.
    fn withdrawn_by(&self) -> &'static [Withdrawal];

    /// Puts the claim to its tests: evidence, facts, and what could not be judged.
    fn judge(&self, _tallies: &Tallies, _into: &mut Judged) {}

    /// The contradiction for certain by one row, without any tally.
    fn look(&self, _draws: &Draws, _row: usize) -> Option<Finding> {
        None
    }

    /// The reason why no test can be made of draws like these: what contradicts them would reject every other claim as well.
    fn precludes(&self, _tallies: &Tallies) -> Option<String> {
        None
    }

    /// The stand-in that is probably meant for an escape in these draws, though nothing says so.
    fn probable_escape(&self, _tallies: &Tallies) -> Option<ProbableEscape> {
        None
    }

    /// The contradiction, for certain, between draws and later ones, of stage 2 or of a second start.
    fn between(&self, _first: &Tallies, _later: &Tallies, _what: &str) -> Option<Fact> {
        None
    }

    /// The finding that a method biased by design should give after so many draws.
    fn design(&self, _draws: u64) -> Design {
        Design::Unbiased
    }

    /// The test that draws may grow under, towards the bound that is asked for.
    fn sequential<'a>(&'a self, _asked: &Asked) -> Option<SequentialTest<'a>> {
        None
    }

    /// The data that a ranking by efficiency needs.
    fn contender<'a>(&'a self, _tallies: &'a Tallies) -> Option<Contender<'a>> {
        None
    }

    /// The law or mean that the subject must have in common with itself in another setting.
    fn comparable<'a>(&self, _tallies: &'a Tallies) -> Option<Comparable<'a>> {
        None
    }

    /// Adds its statement to the results, whether or not anything was drawn.
    fn state(&self, _into: &mut Summary) {}

    /// Adds its findings on the draws to the results.
    fn summarize(&self, _tallies: &Tallies, _into: &mut Summary) {}
}

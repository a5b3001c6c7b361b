use super::LawClaim;
use crate::claim::sequential::{Asked, InterimLook, Sequence, SequentialTest};
use crate::evidence::REPORTING_LEVEL;
use crate::fold::Tallies;
use crate::hypothesis::{Among, sup_distance};
use crate::sequence::{Looks, dkw_band, dkw_p};

/// Growth towards a bound on sup|F - F_subject|.
pub(super) fn test<'a>(claim: &'a LawClaim, asked: &Asked) -> SequentialTest<'a> {
    SequentialTest {
        asked: asked.bound.of(1.0),
        slack: claim.law.slack(),
        what: "sup|F - F_subject|",
        reason: claim.reason,
        sequence: Box::new(Distance(claim)),
        looks: Looks::default(),
    }
}

/// The distance between the distribution functions (Dvoretzky, Kiefer and Wolfowitz 1956), its level shared among the looks.
struct Distance<'a>(&'a LawClaim);

impl Sequence for Distance<'_> {
    fn look(&self, tallies: &Tallies, looks: &mut Looks, _: f64) -> InterimLook {
        let (share, cells) = (looks.next_share(), tallies.counts(self.0.cells));
        let (n, distance) = (cells.draws() as f64, sup_distance(&self.0.law, cells, Among::All));
        let excess = distance.low - self.0.law.slack();
        let p = if excess <= 0.0 { 1.0 } else { dkw_p(n, excess) / share };
        let bound = distance.high + dkw_band(n, REPORTING_LEVEL * share);
        InterimLook { bound, p: looks.note(p), method: "dkw", proven: true, withheld: None }
    }
}

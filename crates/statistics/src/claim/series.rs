use super::{Claim, Withdrawal, counted};
use crate::check;
use crate::evidence::Evidence;
use crate::fold::{Cells, FoldId, Lookups, Tallies};
use crate::hypothesis;
use crate::judged::Judged;
use crate::law::Law;
use crate::tally::CellTally;
use freepath_results::{ClaimResult, Reason};
use std::sync::Arc;

/// Distances along a ray in two parts, drawn one after the other with one generator, follow the law of the whole ray.
pub struct SeriesClaim {
    /// The law of the whole ray.
    pub law: Arc<Law>,
    /// The index of the draws, among those made beside the subject's own.
    pub beside: usize,
    /// Their distances by cell.
    pub cells: FoldId<Cells>,
    /// Their look-ups.
    pub lookups: FoldId<Lookups>,
    /// The reason that a rejection gives.
    pub reason: Reason,
}

impl Claim for SeriesClaim {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new("series", "draws along the ray in two parts follow the law of the whole ray"))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let Some(parts) = tallies.beside.get(self.beside) else { return };
        let (cells, audit) = (parts.counts(self.cells), parts.counts(self.lookups).audit);
        if tallies.assumed.is_some() {
            let why = "what escapes the first part does not say so by infinity";
            into.evidence.push(Evidence::withheld("series", f64::NAN, self.reason, why));
            return;
        }
        if audit.lookups == 0 {
            // it may carry a scene of its own, which has no parts
            let why = "the sampler never looks mu up: it may not heed the medium that it is given";
            into.evidence.push(Evidence::withheld("series", f64::NAN, self.reason, why));
            return;
        }
        inside(cells, audit.outside, into);
        into.evidence.push(hypothesis::series(&self.law, cells, self.reason));
    }
}

fn inside(cells: &CellTally, lookups: u64, into: &mut Judged) {
    let outside = |what: &str| format!("{what} lie outside their part of a ray in two");
    let nan = "draws of a part of the ray are NaN";
    into.facts.extend(counted(check::FINITE, cells.non_finite, Reason::NonFinite, nan));
    into.facts.extend(counted(check::SUPPORT, cells.out_of_support, Reason::OutOfSupport, &outside("draws")));
    into.facts.extend(counted(check::AUDIT, lookups, Reason::OutOfSupport, &outside("look-ups")));
}

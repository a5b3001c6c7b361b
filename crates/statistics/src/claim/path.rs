use super::{Claim, Finding, Summary, Withdrawal, counted};
use crate::check;
use crate::fold::{Cells, FoldId, Strays, Tallies};
use crate::judged::Judged;
use freepath_draws::Draws;
use freepath_results::{ClaimResult, Reason};

/// Every distance lies on the ray or is infinite, as the cells of its law counted it.
pub struct Path {
    /// The column.
    pub column: &'static str,
    /// The far end of the ray.
    pub length: f64,
    /// The column by cell.
    pub cells: FoldId<Cells>,
}

impl Claim for Path {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new("path", "every distance lies on the ray or is infinite"))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let cells = tallies.counts(self.cells);
        strays(cells.non_finite, cells.out_of_support, into);
    }

    fn look(&self, draws: &Draws, row: usize) -> Option<Finding> {
        look(draws.f64(self.column).ok()?[row], self.length)
    }

    fn summarize(&self, tallies: &Tallies, into: &mut Summary) {
        let cells = tallies.counts(self.cells);
        into.audit.non_finite += cells.non_finite;
        into.audit.out_of_support += cells.out_of_support;
    }
}

/// Every distance lies on the ray or is infinite, of a column without a law.
pub struct CountedPath {
    /// The column.
    pub column: &'static str,
    /// The far end of the ray.
    pub length: f64,
    /// The counts of those that do not.
    pub strays: FoldId<Strays>,
}

impl Claim for CountedPath {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new("path", "every distance lies on the ray or is infinite"))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let seen = tallies.counts(self.strays);
        strays(seen.non_finite, seen.out_of_support, into);
    }

    fn look(&self, draws: &Draws, row: usize) -> Option<Finding> {
        look(draws.f64(self.column).ok()?[row], self.length)
    }
}

fn strays(non_finite: u64, out_of_support: u64, into: &mut Judged) {
    into.facts.extend(counted(check::FINITE, non_finite, Reason::NonFinite, "draws are NaN"));
    into.facts.extend(counted(check::SUPPORT, out_of_support, Reason::OutOfSupport, "draws lie outside the ray"));
}

fn look(t: f64, length: f64) -> Option<Finding> {
    if t.is_nan() {
        return Some(Finding { reason: Reason::NonFinite, what: "a distance is NaN".into() });
    }
    let on_the_ray = (t >= 0.0 && t <= length) || t == f64::INFINITY;
    let what = || format!("the distance {t:e} lies outside the ray");
    (!on_the_ray).then(|| Finding { reason: Reason::OutOfSupport, what: what() })
}

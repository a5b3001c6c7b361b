use super::{Claim, Finding, Summary, Withdrawal, counted};
use crate::check;
use crate::evidence::Fact;
use crate::fold::{Cells, FoldId, ProbableEscape, Sentinel, Strays, Tallies};
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
    /// Those that lie elsewhere.
    pub strays: FoldId<Strays>,
    /// The way in which escapes are written.
    pub escapes: Escaping,
}

/// The share of draws that escape, and the way in which their author says so.
#[derive(Clone, Copy)]
pub struct Escaping {
    /// The share of draws that escape; NaN if it is not known.
    pub share: f64,
    /// The advice where something else than infinity stands for an escape.
    pub remedy: fn(Sentinel) -> String,
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
        self.escapes.told(tallies, self.strays, into);
        strays(cells.non_finite, cells.out_of_support, into);
    }

    fn probable_escape(&self, tallies: &Tallies) -> Option<ProbableEscape> {
        self.escapes.probable(tallies, self.strays)
    }

    fn precludes(&self, tallies: &Tallies) -> Option<String> {
        self.escapes.precludes(tallies, self.strays)
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
    /// The way in which escapes are written.
    pub escapes: Escaping,
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
        self.escapes.told(tallies, self.strays, into);
        strays(seen.non_finite, seen.out_of_support, into);
    }

    fn probable_escape(&self, tallies: &Tallies) -> Option<ProbableEscape> {
        self.escapes.probable(tallies, self.strays)
    }

    fn precludes(&self, tallies: &Tallies) -> Option<String> {
        self.escapes.precludes(tallies, self.strays)
    }

    fn look(&self, draws: &Draws, row: usize) -> Option<Finding> {
        look(draws.f64(self.column).ok()?[row], self.length)
    }
}

impl Escaping {
    fn probable(&self, tallies: &Tallies, strays: FoldId<Strays>) -> Option<ProbableEscape> {
        let due = self.share * tallies.draws as f64;
        tallies.counts(strays).probable_escape(tallies.draws, due)
    }

    /// Draws that can be read only once are judged by no test while nobody says what an escape is.
    fn precludes(&self, tallies: &Tallies, strays: FoldId<Strays>) -> Option<String> {
        let left = tallies.assumed.is_none() && self.probable(tallies, strays).is_some();
        left.then(|| "nothing says what an escape is".into())
    }

    /// Tells what was counted as an escape though nothing says so, or would have been if the draws could be read again.
    fn told(&self, tallies: &Tallies, strays: FoldId<Strays>, into: &mut Judged) {
        let (probable, taken) = match tallies.assumed {
            Some(assumed) => (Some(assumed), ", and counted as such here"),
            None => (self.probable(tallies, strays), ""),
        };
        let Some(probable) = probable else { return };
        let (check, reason) = match probable.sentinel {
            Sentinel::Nan => (check::FINITE, Reason::NonFinite),
            Sentinel::Value(_) | Sentinel::FromLength => (check::SUPPORT, Reason::OutOfSupport),
        };
        let remedy = (self.remedy)(probable.sentinel);
        let words = format!("{probable}, and none is infinite: probably escapes{taken} ({remedy})");
        into.facts.push(Fact::new(check.name, reason, words));
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

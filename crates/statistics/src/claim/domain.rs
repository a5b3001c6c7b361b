use super::{Claim, Finding, Summary, Withdrawal, counted};
use crate::check;
use crate::evidence::Evidence;
use crate::fold::{FoldId, Inside, Places, Tallies};
use crate::hypothesis;
use crate::judged::Judged;
use freepath_draws::Draws;
use freepath_results::{ClaimResult, Reason};

/// Every row lies where the law of its columns has mass.
pub struct Domain {
    /// The columns.
    pub columns: &'static [&'static str],
    /// The places where their law has mass, atoms among them.
    pub inside: Inside,
    /// The counts of the rows by place.
    pub places: FoldId<Places>,
}

impl Claim for Domain {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new("domain", "every draw lies where its law has mass"))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let seen = tallies.counts(self.places);
        into.facts.extend(counted(check::FINITE, seen.non_finite, Reason::NonFinite, "draws are NaN"));
        let what = "draws lie where the law has no mass";
        into.facts.extend(counted(check::SUPPORT, seen.outside, Reason::OutOfSupport, what));
    }

    fn look(&self, draws: &Draws, row: usize) -> Option<Finding> {
        let column = |name: &&str| draws.f64(name).ok().map(|column| column[row]);
        let numbers: Vec<f64> = self.columns.iter().map(column).collect::<Option<_>>()?;
        if numbers.iter().any(|x| x.is_nan()) {
            return Some(Finding { reason: Reason::NonFinite, what: "a draw is NaN".into() });
        }
        let what = || format!("the draw {} lies where the law has no mass", listed(&numbers));
        (!(self.inside)(&numbers)).then(|| Finding { reason: Reason::OutOfSupport, what: what() })
    }

    fn summarize(&self, tallies: &Tallies, into: &mut Summary) {
        let seen = tallies.counts(self.places);
        into.audit.non_finite += seen.non_finite;
        into.audit.out_of_support += seen.outside;
    }
}

fn listed(numbers: &[f64]) -> String {
    numbers.iter().map(|x| format!("{x:e}")).collect::<Vec<_>>().join(", ")
}

/// Each atom is drawn as often as its mass says, beside the atom of them all.
pub struct AtomsClaim {
    /// The mass of each.
    pub masses: Vec<f64>,
    /// The most by which each may be off.
    pub slack: f64,
    /// The count of draws at each.
    pub places: FoldId<Places>,
}

impl Claim for AtomsClaim {
    fn statement(&self) -> Option<ClaimResult> {
        Some(ClaimResult::new(
            "atoms",
            format!("each of {} atoms is drawn as often as its mass says", self.masses.len()),
        ))
    }

    fn withdrawn_by(&self) -> &'static [Withdrawal] {
        &[Withdrawal::Truth, Withdrawal::Independent]
    }

    fn judge(&self, tallies: &Tallies, into: &mut Judged) {
        let counts = &tallies.counts(self.places).atoms;
        for (i, (&count, &mass)) in counts.iter().zip(&self.masses).enumerate() {
            let atom = hypothesis::atom(tallies.draws, count, mass, self.slack, Reason::WrongLaw);
            let note = format!(
                "{:.6} of the draws are this atom, {mass:.6} should be",
                count as f64 / tallies.draws as f64
            );
            into.evidence.push(Evidence { name: format!("atom_{i}"), ..atom }.noted(note));
        }
    }
}

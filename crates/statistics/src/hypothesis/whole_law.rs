use super::distance::{Among, Bracket, sup_distance};
use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass};
use crate::law::Law;
use crate::special::ks_two_sided;
use crate::tally::CellTally;
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "whole_law",
    words: "The largest gap between the empirical and the analytic CDF of all draws, an escape counted beyond the end: what `bound` \
and `detectable` of a law are about.",
    details: "\
```text
D = sup |F_n(t) - F(t)| over the edges of the fine cells,   F_n of all n draws
```
Gate:    none. The atom at the end and the edges make the p-value conservative.
Rejects: as wrong_law; as biased against the truth of a method that is biased by design.
Sees:    an error that is half in the escapes and half in where the collisions lie, which atom and kolmogorov each see too little of.
Source:  Kolmogorov (1933); discontinuous laws are on the safe side (Noether 1963).",
    nulls: &[NullClass::Conservative],
    alone: Alone::Proven,
    section: "whole_law",
};

/// Kolmogorov-Smirnov on all draws, escapes at the end.
#[must_use]
pub fn whole_law(law: &Law, tally: &CellTally, reason: Reason) -> Evidence {
    let n = tally.draws();
    if n == 0 {
        return Evidence::withheld(TEST.name, f64::NAN, reason, "nothing was drawn").alone();
    }
    let Bracket { low, high } = sup_distance(law, tally, Among::All);
    let d = if low > law.slack() { low - law.slack() } else { 0.0 };
    let p = if low.is_nan() { f64::NAN } else { ks_two_sided(n, d) };
    let evidence = Evidence::new(TEST.name, low, None, p, reason).under(Null::Conservative).alone();
    evidence.noted(format!("D between {low:.3e} and {high:.3e}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hypothesis::{atom, kolmogorov};

    fn tally(law: &Law, n: u64, survival: impl Fn(f64) -> f64) -> CellTally {
        let mut tally = CellTally::new(law);
        let reached = |k: usize| ((1.0 - survival(law.edge(k))) * n as f64).round() as u64;
        for k in 0..law.cells() {
            tally.cells[k] = reached(k + 1) - reached(k);
        }
        tally.escapes = n - tally.collided();
        tally
    }

    /// Too many escapes, and the collisions too late.
    #[test]
    fn what_is_half_in_the_atom_and_half_in_the_law_is_seen_here() {
        let (law, n) = (Law::new(1.0, 0.0, |t| 1.0 - 0.5 * t), 100_000);
        let late = |t: f64| if t < 0.5 { 0.018 * t } else { 0.012 - 0.006 * t };
        let moved = tally(&law, n, |t| 1.0 - 0.5 * t + late(t));
        let p = |evidence: Evidence| evidence.p.unwrap_or(0.0);
        let whole = p(whole_law(&law, &moved, Reason::WrongLaw));
        let atom = p(atom(n, moved.escapes, law.atom(), 0.0, Reason::WrongLaw));
        let collided = p(kolmogorov(&law, &moved, Reason::WrongLaw));
        assert!(whole < 1e-6 && whole < 0.5 * atom && whole < 0.5 * collided, "{whole:e} {atom:e} {collided:e}");
    }

    #[test]
    fn the_right_law_fits_within_its_slack_and_another_does_not() {
        let of = |rate: f64, slack| {
            let law = Law::new(2.0, slack, |t| libm::exp(-t));
            whole_law(&law, &tally(&law, 100_000, |t| libm::exp(-rate * t)), Reason::WrongLaw).p
        };
        assert!(of(1.0, 0.0) > Some(0.99) && of(1.1, 0.0) < Some(1e-6) && of(1.1, 0.04) > Some(0.99));
    }

    #[test]
    fn a_nan_inside_the_law_rejects() {
        let law = Law::new(2.0, 0.0, |t| if (0.9..1.0).contains(&t) { f64::NAN } else { libm::exp(-t) });
        let mut tally = CellTally::new(&law);
        tally.observe(&law, &[0.3, 1.2, f64::INFINITY], &mut Vec::new());
        assert_eq!(whole_law(&law, &tally, Reason::WrongLaw).p, Some(0.0));
    }
}

use super::distance::{Among, Bracket, sup_distance};
use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass};
use crate::law::Law;
use crate::special::ks_two_sided;
use crate::tally::CellTally;
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "kolmogorov",
    words: "The largest gap between the empirical and the analytic CDF of the collided draws (Kolmogorov 1933), taken \
over the edges of the fine cells: never above the true D, so the p-value is valid and a few percent conservative. The note \
brackets D.",
    details: "\
```text
D = sup |F_m(u) - u| over the edges of the fine cells,   u = F(t) / F(length) of the m draws that collide
```
Gate:    at least one collision. Edges make the p-value a few percent conservative, never liberal.
Rejects: as wrong_law; as biased against the truth of a method that is biased by design.
Source:  Kolmogorov (1933); p by Durbin (1973), Pelz and Good (1976), Birnbaum and Tingey (1951).",
    nulls: &[NullClass::Conservative],
    alone: Alone::Proven,
    section: "kolmogorov",
};

/// Kolmogorov-Smirnov on u = F(t) / F(length) of the collided draws, which is independent of the escape atom.
///
/// ```text
/// D_edges = max over edges |F_m - F|  <=  D  <=  max over cells of the gap that a cell may hide
/// ```
#[must_use]
pub fn kolmogorov(law: &Law, tally: &CellTally, reason: Reason) -> Evidence {
    let m = tally.collided();
    if m == 0 {
        return Evidence::withheld(TEST.name, f64::NAN, reason, "no draw collided").alone();
    }
    let Bracket { low, high } = sup_distance(law, tally, Among::Collided);
    let slack = 2.0 * law.slack() / law.collided(); // of F(t) and of F(length)
    let d = if low > slack { low - slack } else { 0.0 };
    let p = if low.is_nan() { f64::NAN } else { ks_two_sided(m, d) };
    let evidence = Evidence::new(TEST.name, low, None, p, reason).under(Null::Conservative).alone();
    evidence.noted(format!("D between {low:.3e} and {high:.3e}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn p(rate: f64) -> Option<f64> {
        let law = Law::new(2.0, 0.0, |t| libm::exp(-t));
        let t: Vec<f64> = (0..100_000).map(|i| -libm::log(1.0 - (f64::from(i) + 0.5) / 1e5) / rate).collect();
        let t: Vec<f64> = t.iter().map(|&t| if t < 2.0 { t } else { f64::INFINITY }).collect();
        let mut tally = CellTally::new(&law);
        tally.observe(&law, &t, &mut Vec::new());
        kolmogorov(&law, &tally, Reason::WrongLaw).p
    }

    #[test]
    fn a_nan_inside_the_law_rejects() {
        let law = Law::new(2.0, 0.0, |t| if (0.9..1.0).contains(&t) { f64::NAN } else { libm::exp(-t) });
        let mut tally = CellTally::new(&law);
        tally.observe(&law, &[0.3, 1.2], &mut Vec::new());
        assert_eq!(kolmogorov(&law, &tally, Reason::WrongLaw).p, Some(0.0));
    }

    #[test]
    fn the_right_law_fits_and_another_does_not() {
        assert!(p(1.0) > Some(0.99));
        assert!(p(1.2) < Some(1e-6));
    }
}

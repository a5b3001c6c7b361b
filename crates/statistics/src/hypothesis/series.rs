use super::atom::atom;
use super::chi_square::chi_square;
use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass};
use crate::law::Law;
use crate::tally::CellTally;
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "series",
    words: "The ray cut in two: a draw that escapes the first part goes on in the second with the same generator, and \
the whole distance follows the whole law. State or a uniform that is used again across the boundary shows here alone. Not asked of a sampler that never looks mu up.",
    details: "\
```text
T(0, d) = T(0, s) T(s, d):   p = min(1, 2 min(p of the atom, p of 16 cells))
```
Gate:    as atom and chi_square_16.
Rejects: as wrong_law: a uniform or a state that is used again across a boundary, where each part alone is exact.",
    nulls: &[NullClass::Conservative],
    alone: Alone::No,
    section: "series",
};

/// The law of a ray in two parts, T(0, d) = T(0, s) T(s, d), by the escape atom and 16 cells.
///
/// ```text
/// p = min(1, 2 min(p of the atom, p of chi-square))
/// ```
#[must_use]
pub fn series(law: &Law, tally: &CellTally, reason: Reason) -> Evidence {
    let escapes = atom(tally.draws(), tally.escapes, law.atom(), law.slack(), reason);
    let cells = chi_square(TEST.name, law, tally, 16, reason);
    let worse = match (escapes.p, cells.p) {
        (Some(a), Some(b)) if !(a >= b) => escapes,
        (_, None) => {
            return Evidence { name: "series".into(), p_alone: None, ..escapes }.under(Null::Conservative);
        }
        _ => cells,
    };
    let p = worse.p.map_or(f64::NAN, |p| if p > 0.5 { 1.0 } else { 2.0 * p });
    Evidence::new(TEST.name, worse.statistic, worse.dof, p, reason).noted(worse.note).under(Null::Conservative)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn p(law: &Law, t: &[f64]) -> Option<f64> {
        let mut tally = CellTally::new(law);
        tally.observe(law, t, &mut Vec::new());
        series(law, &tally, Reason::WrongLaw).p
    }

    #[test]
    fn escapes_and_distances_both_count_and_one_of_them_is_enough() {
        let law = Law::new(2.0, 0.0, |t| libm::exp(-t));
        let inverse = |i: u32| -libm::log(1.0 - (f64::from(i) + 0.5) / 16_384.0);
        let ended = |t: f64| if t < 2.0 { t } else { f64::INFINITY };
        let right: Vec<f64> = (0..16_384).map(|i| ended(inverse(i))).collect();
        assert!(p(&law, &right) > Some(0.9));
        let few: Vec<f64> = (0..16_384).map(|i| ended(0.9 * inverse(i))).collect();
        assert!(p(&law, &few) < Some(1e-9));
        let thin = Law::new(2.0, 0.0, |t| libm::exp(-1e-4 * t));
        assert!(p(&thin, &[f64::INFINITY; 16_384]).is_some(), "the atom alone");
    }
}

use super::chi_square::{Demand, standardised};
use super::record::Test;
use crate::evidence::{Alone, Evidence, NullClass};
use crate::law::Law;
use crate::special::chi_square_cdf;
use crate::tally::CellTally;
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "too_even",
    words: "Counts in cells that lie nearer to what is expected than those of independent draws: the other tail of chi-square.",
    details: "\
```text
X = sum (O - E)^2 / E,   E = n p,   p = P((cells - 1) / 2, X / 2)
```
The cells of chi_square_64 or of chi_square_fine, whichever are more; no |O - E| is lessened by a tolerance.
Gate:    33 cells that expect 50 draws each.
Rejects: as dependent.
Sees:    stratified or quasi-random draws, a generator whose period is near the number of draws.
Source:  Fisher (1936), of Mendel's peas.",
    nulls: &[NullClass::Uniform],
    alone: Alone::Measured,
    section: "too_even",
};

/// Fewest cells: with fewer, the left tail comes from a few counts that happen to fit.
const FEWEST: usize = 33;
/// Draws that each must expect: p is 0.98 to 1.07 of nominal from 1e-3 to 1e-12, by enumeration of 33 cells.
const EACH: f64 = 50.0;

/// The left tail of Pearson's chi-square over at most `wanted` equiprobable cells and the escape cell.
///
/// A law that is off makes X larger, so that no slack is taken off: with lessened differences most right samplers would look even.
#[must_use]
pub fn too_even(law: &Law, tally: &CellTally, wanted: usize) -> Evidence {
    let demand = Demand { wanted, least: |_| EACH, slack: 0.0 };
    let Some((_, residual, _)) = standardised(law, tally, demand).filter(|(_, all, _)| all.len() >= FEWEST) else {
        let why = format!("fewer than {FEWEST} cells would expect {EACH} of {} draws", tally.draws());
        return Evidence::withheld(TEST.name, f64::NAN, Reason::Dependent, why).alone();
    };
    let statistic: f64 = residual.iter().map(|r| r * r).sum();
    let dof = (residual.len() - 1) as f64;
    let evidence =
        Evidence::new(TEST.name, statistic, Some(dof), chi_square_cdf(dof, statistic), Reason::Dependent);
    evidence.alone().noted(format!("counts of independent draws would give {dof}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_draws::Key;
    use freepath_draws::random::uniform;

    fn uniform_law(slack: f64) -> Law {
        Law::new(1.0, slack, |t| 1.0 - t)
    }

    fn evidence(law: &Law, draws: usize, draw: impl FnMut(usize) -> f64) -> Evidence {
        let mut tally = CellTally::new(law);
        tally.observe(law, &(0..draws).map(draw).collect::<Vec<_>>(), &mut Vec::new());
        too_even(law, &tally, 64)
    }

    #[test]
    fn one_draw_in_each_stratum_is_too_even_and_may_fail_alone() {
        let mut rng = Key { seed: 1, subject: 3, block: 0 }.rng();
        let stratified = evidence(&uniform_law(0.0), 20_000, |i| (i as f64 + uniform(&mut rng)) / 20_000.0);
        assert!(stratified.p < Some(1e-40) && stratified.p_alone == stratified.p, "{stratified:?}");
        assert_eq!(stratified.reason, Reason::Dependent);
    }

    #[test]
    fn a_tolerance_makes_no_right_draws_look_even() {
        let mut rng = Key { seed: 2, subject: 3, block: 0 }.rng();
        let draws: Vec<f64> = (0..20_000).map(|_| uniform(&mut rng)).collect();
        let p = |slack| evidence(&uniform_law(slack), 20_000, |i| draws[i]).p;
        assert!(p(0.0) == p(0.01) && p(0.0) > Some(1e-3), "{:?} {:?}", p(0.0), p(0.01));
    }

    #[test]
    fn thirty_three_cells_of_fifty_are_needed() {
        let of = |draws: usize| evidence(&uniform_law(0.0), draws, |i| (i as f64 + 0.5) / draws as f64);
        assert!(of(1_600).p.is_none() && of(1_600).p_alone == Some(1.0) && of(1_900).p.is_some());
    }

    #[test]
    fn it_keeps_its_level() {
        let law = uniform_law(0.0);
        let p = |seed| {
            let mut rng = Key { seed, subject: 4, block: 0 }.rng();
            evidence(&law, 4_000, |_| uniform(&mut rng)).p.unwrap_or(0.0)
        };
        let all: Vec<f64> = (0..2_000).map(p).collect();
        for level in [0.003, 0.01, 0.1, 0.5] {
            let below = all.iter().filter(|p| !(**p > level)).count() as u64;
            assert!(crate::special::binomial_two_sided(2_000, level, below) > 1e-4, "{below} of 2000 at {level}");
        }
    }
}

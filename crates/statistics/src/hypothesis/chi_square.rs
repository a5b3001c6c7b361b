use super::record::Test;
use crate::detection::Detection;
use crate::evidence::{Alone, Evidence, NullClass};
use crate::law::{Groups, LEAST_SHARE, Law};
use crate::special::chi_square_sf;
use crate::tally::CellTally;
use freepath_results::Reason;

/// The records of the test with 16, with 64 and with some 2 n^0.4 cells.
pub(super) const TESTS: [Test; 3] = [of("chi_square_16"), of("chi_square_64"), of("chi_square_fine")];

const fn of(name: &'static str) -> Test {
    Test {
        name,
        words: "Counts in nearly equiprobable cells of the free path, and of escapes, against their probabilities \
(Pearson 1900). 16 cells see broad errors best, 64 and about 2 n^0.4 cells see narrow ones.",
        details: "\
```text
X = sum (O - E)^2 / E,   E = n p,   p = Q((cells - 1) / 2, X / 2)
```
Gate:    every cell expects 100 draws, or 800 over the cells if there are fewer than 8; else fewer cells.
Rejects: as wrong_law; as biased against the truth of a method that is biased by design.
Alone:   where every cell expects 500 draws, or 8000 over the cells if there are fewer than 16.
Sees:    16 cells broad errors, 64 and 2 n^0.4 cells an error in one voxel.
Source:  Pearson (1900).",
        nulls: &[NullClass::Uniform],
        alone: Alone::Measured,
        section: "chi_square_16-chi_square_64-chi_square_fine",
    }
}

/// Least expectation of each of so many cells. Below it the chi-square tail is not trusted: with 17 cells of 50 p-values of 1e-7
/// come 1.4 times too often, of 100 1.2 times, by enumeration; with 2 cells of 50 more than 4 times, since the skewness of a single
/// cell shows.
#[must_use]
pub fn least_expected(cells: usize) -> f64 {
    if cells < 8 { 800.0 / cells as f64 } else { 100.0 }
}

/// Least expectation of each of so many cells where the test may reject alone: p-values of 1e-9 come 1.13 times too often there.
fn least_alone(cells: usize) -> f64 {
    if cells < 16 { 8000.0 / cells as f64 } else { 500.0 }
}

/// Pearson's chi-square over about `wanted` equiprobable cells and the escape cell.
///
/// ```text
/// X = sum (O - E)^2 / E,   E = n p,   dof = cells - 1
/// ```
///
/// Fewer cells are used where the expectation would fall below 100, or 800 over the cells; an escape cell that expects fewer
/// joins the last.
/// Each |O - E| is lessened by 2 n times the law's slack: a cell has two edges.
#[must_use]
pub fn chi_square(name: &str, law: &Law, tally: &CellTally, wanted: usize, reason: Reason) -> Evidence {
    let (n, seen) = (tally.draws() as f64, residuals(law, tally, wanted));
    let Some((groups, residual, escape)) = seen else {
        let why = format!("fewer than two cells would expect {} of {n} draws", least_expected(2));
        return Evidence::withheld(name, f64::NAN, reason, why);
    };
    let statistic: f64 = residual.iter().map(|r| r * r).sum();
    let dof = (residual.len() - 1) as f64;
    let evidence = Evidence::new(name, statistic, Some(dof), chi_square_sf(dof, statistic), reason);
    if may_reject_alone(n, &groups, escape.then(|| law.atom())) { evidence.alone() } else { evidence }
}

/// True if every cell expects so many draws that the tail is known to 1e-9.
fn may_reject_alone(n: f64, groups: &Groups, escape: Option<f64>) -> bool {
    let mut all = groups.mass.iter().copied().chain(escape);
    let least = least_alone(groups.mass.len() + usize::from(escape.is_some()));
    all.all(|mass| n * mass >= least)
}

/// The cells that are asked for.
#[derive(Clone, Copy)]
pub(super) struct Demand {
    /// Most groups, beside the escape cell.
    pub(super) wanted: usize,
    /// Least expectation of each of so many cells.
    pub(super) least: fn(usize) -> f64,
    /// The most by which the law may be off.
    pub(super) slack: f64,
}

/// The groups, (O - E) / sqrt(E) of each and then of the escape cell, and whether there is one; nothing if fewer than two
/// cells are left.
#[must_use]
pub fn residuals(law: &Law, tally: &CellTally, wanted: usize) -> Option<(Groups, Vec<f64>, bool)> {
    standardised(law, tally, Demand { wanted, least: least_expected, slack: law.slack() })
}

/// [`residuals`] of other cells, or with another slack than that of the law.
pub(super) fn standardised(law: &Law, tally: &CellTally, demand: Demand) -> Option<(Groups, Vec<f64>, bool)> {
    let n = tally.draws() as f64;
    let (cells, escape) = affordable(n * law.collided(), n * law.atom(), demand)?;
    let groups = law.groups(cells);
    let mut observed = groups.gather(&tally.cells);
    let mut mass = groups.mass.clone();
    if escape {
        observed.push(tally.escapes);
        mass.push(law.atom());
    } else if let (Some(o), Some(m)) = (observed.last_mut(), mass.last_mut()) {
        *o += tally.escapes;
        *m += law.atom();
    }
    let residual = observed.iter().zip(&mass).map(|(&o, &p)| residual(o as f64, n * p, 2.0 * n * demand.slack));
    let residual: Vec<f64> = residual.collect();
    // one cell may hold the share of all
    (residual.len() >= 2).then_some((groups, residual, escape))
}

/// The smallest relative error of one cell of 64 that the test would have seen in both stages with the usual power, the other cells
/// sharing the difference; of the lightest cell, so that it holds for each. None where the test is withheld.
///
/// ```text
/// r = sqrt(l (1 - p) / p) + 2 slack / p,   l = sum (q - p)^2 / p the noncentrality of one draw that the power needs
/// ```
#[must_use]
pub fn detectable_cell(law: &Law, tally: &CellTally, detection: &Detection) -> Option<f64> {
    let (groups, residual, _) = residuals(law, tally, 64)?;
    let lightest = groups.mass.iter().copied().reduce(|a, b| if b < a { b } else { a })?;
    let noncentrality = detection.noncentrality((residual.len() - 1) as f64);
    Some((noncentrality * (1.0 - lightest) / lightest).sqrt() + 2.0 * law.slack() / lightest)
}

/// At most the wanted cells for so many collisions, and whether so many escapes make one of their own.
fn affordable(collisions: f64, escapes: f64, demand: Demand) -> Option<(usize, bool)> {
    let enough = |&(cells, escape): &(usize, bool)| {
        let total = cells + usize::from(escape);
        total >= 2 && LEAST_SHARE * collisions / cells as f64 >= (demand.least)(total)
    };
    let with_escape = |cells| (cells, escapes >= (demand.least)(cells + 1));
    (1..=demand.wanted).rev().map(with_escape).find(enough)
}

/// (O - E) / sqrt(E), with |O - E| lessened by `slack`.
pub(crate) fn residual(observed: f64, expected: f64, slack: f64) -> f64 {
    lessened(observed - expected, slack) / expected.sqrt()
}

/// The difference brought towards 0 by `slack`; NaN stays.
pub(crate) fn lessened(difference: f64, slack: f64) -> f64 {
    let size = difference.abs() - slack;
    (if size < 0.0 { 0.0 } else { size }).copysign(difference)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tally(rate: f64) -> (Law, CellTally) {
        let law = Law::new(2.0, 0.0, |t| libm::exp(-t));
        let t: Vec<f64> = (0..100_000).map(|i| -libm::log(1.0 - (f64::from(i) + 0.5) / 1e5) / rate).collect();
        let t: Vec<f64> = t.iter().map(|&t| if t < 2.0 { t } else { f64::INFINITY }).collect();
        let mut tally = CellTally::new(&law);
        tally.observe(&law, &t, &mut Vec::new());
        (law, tally)
    }

    #[test]
    fn the_right_law_fits_and_one_five_percent_off_does_not() {
        let p = |rate| {
            let (law, tally) = tally(rate);
            chi_square("chi_square_64", &law, &tally, 64, Reason::WrongLaw).p
        };
        assert!(p(1.0) > Some(0.5));
        assert!(p(1.05) < Some(1e-6));
    }

    #[test]
    fn cells_of_500_may_reject_alone_and_smaller_ones_not() {
        let (law, tally) = tally(1.0);
        let alone = |cells| chi_square("chi_square_64", &law, &tally, cells, Reason::WrongLaw).p_alone.is_some();
        assert!(alone(16) && alone(64) && !alone(400));
    }

    #[test]
    fn too_few_draws_are_withheld() {
        let law = Law::new(2.0, 0.0, |t| libm::exp(-t));
        let empty = CellTally::new(&law);
        assert_eq!(chi_square("chi_square_16", &law, &empty, 16, Reason::WrongLaw).p, None);
    }
}

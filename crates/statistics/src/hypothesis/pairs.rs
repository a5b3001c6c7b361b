use super::record::Test;
use crate::evidence::{Alone, Evidence, NullClass};
use crate::special::chi_square_sf;
use crate::tally::{LagTally, RANK_GROUPS};
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "pairs_16",
    words: "A table of neighbouring draws, 16 x 16 groups of equal probability under the law with escapes: rows and \
columns are independent. It sees dependence that leaves no correlation, such as a reused uniform that was folded.",
    details: "\
```text
X = sum (O_ab - R_a C_b / N)^2 / (R_a C_b / N),   dof = (k - 1)^2,   R, C the sums of rows and columns
```
Gate:    neighbouring groups are joined until each cell expects 100 pairs, or more if there are few.
Rejects: as dependent: dependence that leaves no correlation, such as a reused uniform that was folded.
Source:  Bartlett (1951), Anderson and Goodman (1957): overlapping pairs keep the chi-square law.",
    nulls: &[NullClass::Uniform],
    alone: Alone::No,
    section: "pairs_16",
};

/// Independence of consecutive draws, over all overlapping pairs.
///
/// ```text
/// X = sum (O_ab - R_a C_b / N)^2 / (R_a C_b / N),   dof = (k - 1)^2
/// ```
///
/// R and C are the sums of rows and columns, so that a wrong law is not called dependent. Overlapping pairs depend on one
/// another, but their interactions with both margins taken out do not correlate: this is the test of order 0 against order 1
/// of a chain (Bartlett 1951; Anderson and Goodman 1957), what Good's serial statistic psi^2_2 - psi^2_1 (1953) becomes when
/// the margins are not given. Neighbouring groups are joined until every cell expects 100, or 200 where there are fewer than 16 groups: a choice by margins alone, given
/// which the test is made.
#[must_use]
pub fn pairs(tally: &LagTally) -> Evidence {
    let name = TEST.name;
    let total: u64 = tally.neighbours.as_flattened().iter().sum();
    let tables = [100.0, 200.0, 400.0].map(|least| joined(tally, (least * total as f64).sqrt()));
    let enough = |table: &Vec<Vec<f64>>| {
        let (k, least) = (table.len(), if table.len() < RANK_GROUPS { 200.0 } else { 100.0 });
        let expected = margins(table).0.into_iter().fold(f64::INFINITY, |a, b| if b < a { b } else { a });
        k >= 2 && total > 0 && expected * expected >= least * total as f64
    };
    let Some(table) = tables.into_iter().find(enough) else {
        let why = "fewer than two groups of draws are large enough for a table of pairs";
        return Evidence::withheld(name, f64::NAN, Reason::Dependent, why);
    };
    let (rows, columns) = margins(&table);
    let cells =
        table.iter().zip(&rows).flat_map(|(row, r)| row.iter().zip(&columns).map(move |(o, c)| (o, r * c)));
    let statistic: f64 =
        cells.map(|(o, rc)| (o - rc / total as f64, rc / total as f64)).map(|(d, e)| d * d / e).sum();
    let dof = ((table.len() - 1) * (table.len() - 1)) as f64;
    Evidence::new(name, statistic, Some(dof), chi_square_sf(dof, statistic), Reason::Dependent)
}

/// Sums of rows and of columns.
fn margins(table: &[Vec<f64>]) -> (Vec<f64>, Vec<f64>) {
    let rows = table.iter().map(|row| row.iter().sum()).collect();
    let columns = (0..table.len()).map(|b| table.iter().map(|row| row[b]).sum()).collect();
    (rows, columns)
}

/// The table with neighbouring groups joined until each holds `least` pairs in its row and in its column; what is left joins
/// the last.
fn joined(tally: &LagTally, least: f64) -> Vec<Vec<f64>> {
    let table = &tally.neighbours;
    let (mut bounds, mut held) = (vec![0], (0, 0));
    for a in 0..table.len() {
        let column: u64 = table.iter().map(|row| row[a]).sum();
        held = (held.0 + table[a].iter().sum::<u64>(), held.1 + column);
        if held.0 as f64 >= least && held.1 as f64 >= least {
            bounds.push(a + 1);
            held = (0, 0);
        }
    }
    if let Some(last) = bounds.last_mut() {
        *last = table.len();
    }
    let sum =
        |a: &[usize], b: &[usize]| table[a[0]..a[1]].iter().flat_map(|row| &row[b[0]..b[1]]).sum::<u64>() as f64;
    bounds.windows(2).map(|a| bounds.windows(2).map(|b| sum(a, b)).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::Law;
    use crate::tally::{CellTally, Scores};
    use freepath_draws::random::uniform;

    fn p(rate: f64, t: &[f64]) -> Option<f64> {
        let law = Law::new(2.0, 0.0, |t| libm::exp(-rate * t));
        let (scores, mut cells, mut index) = (Scores::new(&law), CellTally::new(&law), Vec::new());
        cells.observe(&law, t, &mut index);
        let mut tally = LagTally::default();
        tally.observe(&scores, &index);
        pairs(&tally).p
    }

    fn draws(n: usize) -> Vec<f64> {
        let mut rng = freepath_draws::Key::default().rng();
        (0..n).map(|_| 2.0 * uniform(&mut rng)).collect()
    }

    #[test]
    fn independent_draws_of_any_law_pass_and_a_folded_uniform_does_not() {
        let plain = draws(60_000);
        for rate in [0.5, 1.0, 3.0] {
            assert!(p(rate, &plain) > Some(1e-3), "{rate}");
        }
        let tent = |t: f64| 2.0 - 2.0 * (t - 1.0).abs();
        let folded: Vec<f64> = plain.iter().flat_map(|&t| [t, tent(t)]).collect();
        assert!(p(1.0, &folded) < Some(1e-9));
    }

    #[test]
    fn too_few_pairs_are_withheld() {
        assert_eq!(p(1.0, &draws(500)), None);
        assert_eq!(p(1e-5, &vec![f64::INFINITY; 60_000]), None);
    }
}

use super::chi_square::least_expected;
use super::record::Test;
use crate::evidence::{Alone, Evidence, NullClass};
use crate::special::chi_square_sf;
use crate::tally::AuxiliaryTally;
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "auxiliary",
    words: "The auxiliary number that a sampler gives with each distance, such as the cosine of the direction it started in, is \
uniform and independent of the distance: a table of 16 x 16 groups.",
    details: "\
```text
X = sum (O_ab - R_a / 16)^2 / (R_a / 16),   dof = 15 rows,   R_a draws in group a of the distance
```
Gate:    groups of the distance are joined until each cell expects 100 draws, or more if there are few.
Rejects: as dependent: a direction and a flight from one random number, each right by itself.",
    nulls: &[NullClass::Uniform],
    alone: Alone::No,
    section: "auxiliary",
};

/// Auxiliary numbers given distances.
///
/// ```text
/// X = sum (O_ab - R_a / 16)^2 / (R_a / 16),   dof = 15 x rows,   R_a draws in group a of the distance
/// ```
///
/// R_a is as it was drawn, so that a wrong law is not called dependent. Neighbouring groups of the distance are joined until
/// each cell expects 100, or 800 over the cells.
#[must_use]
pub fn auxiliary(tally: &AuxiliaryTally) -> Evidence {
    let columns = tally.counts[0].len();
    let tables = [100.0, 200.0].map(|least| joined(tally, least * columns as f64));
    let enough = |rows: &Vec<Vec<u64>>| {
        let share = |row: &Vec<u64>| row.iter().sum::<u64>() as f64 / columns as f64;
        !rows.is_empty() && rows.iter().all(|row| share(row) >= least_expected(rows.len() * columns))
    };
    let Some(rows) = tables.into_iter().find(enough) else {
        return Evidence::withheld(TEST.name, f64::NAN, Reason::Dependent, "too few draws with a number");
    };
    let statistic: f64 = rows.iter().map(|row| of_row(row)).sum();
    let dof = (rows.len() * (columns - 1)) as f64;
    Evidence::new(TEST.name, statistic, Some(dof), chi_square_sf(dof, statistic), Reason::Dependent)
}

fn of_row(row: &[u64]) -> f64 {
    let expected = row.iter().sum::<u64>() as f64 / row.len() as f64;
    row.iter().map(|&o| o as f64 - expected).map(|d| d * d / expected).sum()
}

/// Neighbouring rows joined until each holds `least` draws; what is left joins the last.
fn joined(tally: &AuxiliaryTally, least: f64) -> Vec<Vec<u64>> {
    let columns = tally.counts[0].len();
    let add = |a: &mut Vec<u64>, b: &[u64]| a.iter_mut().zip(b).for_each(|(a, b)| *a += b);
    let (mut rows, mut part) = (Vec::new(), vec![0; columns]);
    for row in tally.counts.iter() {
        add(&mut part, row);
        if part.iter().sum::<u64>() as f64 >= least {
            rows.push(std::mem::replace(&mut part, vec![0; columns]));
        }
    }
    if let Some(last) = rows.last_mut() {
        add(last, &part);
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::Law;
    use crate::tally::{CellTally, Scores};
    use freepath_draws::random::uniform;

    fn tally(number: impl Fn(f64, f64) -> f64) -> AuxiliaryTally {
        let law = Law::new(2.0, 0.0, |t| libm::exp(-t));
        let (mut tally, mut index, scores) = (AuxiliaryTally::default(), Vec::new(), Scores::new(&law));
        let mut rng = freepath_draws::Key::default().rng();
        let mut draw = |_| {
            let (t, u) = (uniform(&mut rng), uniform(&mut rng));
            (2.0 * t, number(t, u))
        };
        let (t, numbers): (Vec<f64>, Vec<f64>) = (0..60_000).map(&mut draw).unzip();
        CellTally::new(&law).observe(&law, &t, &mut index);
        tally.observe(&scores, &numbers, &index);
        tally
    }

    #[test]
    fn independent_numbers_pass_and_others_do_not() {
        assert!(auxiliary(&tally(|_, u| u)).p > Some(1e-3));
        assert!(auxiliary(&tally(|t, u| if u < 0.1 { t } else { (u - 0.1) / 0.9 })).p < Some(1e-9));
        assert!(auxiliary(&tally(|_, u| u * u)).p < Some(1e-9));
    }

    #[test]
    fn spoilt_numbers_are_counted_and_none_are_withheld() {
        let spoilt = tally(|t, u| if t < 0.5 { f64::NAN } else { 1.0 + u });
        assert_eq!((spoilt.spoilt, auxiliary(&spoilt).p), (60_000, None));
    }
}

//! Auxiliary numbers by distance, and two samples of one law by cell: rows of a table, each a multinomial of its own.

use crate::Effort;
use crate::table::Row;
use freepath_calibration::multinomial::{Multinomial, quantile};
use freepath_calibration::tail::Tail;
use freepath_results::Reason;
use freepath_statistics::Evidence;
use freepath_statistics::hypothesis::{agree_law, auxiliary};
use freepath_statistics::special::chi_square_sf;
use freepath_statistics::tally::{AuxiliaryTally, CellTally};

/// A table of `rows` rows, each of draws that expect `each` in each of `columns` cells.
struct Table {
    rows: usize,
    columns: usize,
    each: f64,
    dof: usize,
    test: fn(&[Vec<u64>]) -> Evidence,
}

pub(crate) fn rows(effort: Effort) -> Vec<Row> {
    let numbers = [1, 4, 16].map(|rows| {
        let table = Table { rows, columns: 16, each: 50.0, dof: 15 * rows, test: of_numbers };
        Row::new("auxiliary", format!("groups of distance: {rows}, 50 in each cell"), true, |level| {
            vec![table.tail(level, effort)]
        })
    });
    let samples = [(2, 75.0), (16, 75.0), (60, 75.0), (2, 1e4)].map(|(rows, each)| {
        let table = Table { rows, columns: 2, each, dof: rows - 1, test: of_samples };
        let setting = format!("{rows} cells that hold {:.0} draws of both samples, no escapes", 2.0 * each);
        Row::new("agree_majorant", setting, true, |level| vec![table.tail(level, effort)])
    });
    numbers.into_iter().chain(samples).collect()
}

impl Table {
    fn tail(&self, level: f64, effort: Effort) -> Tail {
        let dof = self.dof as f64;
        let row = Multinomial::expecting(&vec![self.each; self.columns]);
        let spread = row.spread(quantile(|x| chi_square_sf(dof, x), level) / dof);
        Tail::measure(effort.seed, effort.replicates, |rng| {
            let counts: Vec<Vec<u64>> = (0..self.rows).map(|_| spread.counts(rng)).collect();
            let there = (self.test)(&counts).p.is_some_and(|p| !(p > level));
            if there { libm::exp(counts.iter().map(|row| spread.log_ratio(row)).sum()) } else { 0.0 }
        })
    }
}

fn of_numbers(counts: &[Vec<u64>]) -> Evidence {
    let mut tally = AuxiliaryTally::default();
    for (group, row) in tally.counts.iter_mut().zip(counts) {
        group.copy_from_slice(row);
    }
    auxiliary(&tally)
}

/// A row for each cell: what it holds of either sample.
fn of_samples(counts: &[Vec<u64>]) -> Evidence {
    let sample =
        |i: usize| CellTally { cells: counts.iter().map(|cell| cell[i]).collect(), ..CellTally::default() };
    agree_law("agree_majorant", [&sample(0), &sample(1)], 0.0, Reason::WrongLaw)
}

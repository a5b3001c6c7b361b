//! The left tail of Pearson's chi-square, by enumeration of equal cells.

use crate::Effort;
use crate::table::Row;
use freepath_calibration::enumeration::EqualCells;
use freepath_calibration::tail::Tail;
use freepath_statistics::special::chi_square_cdf;

pub(crate) fn rows(_: Effort) -> Vec<Row> {
    let row = |count: usize, used: bool| {
        let cells = EqualCells { count, each: 50 };
        let dof = (count - 1) as f64;
        Row::new("too_even", format!("{count} cells expecting 50"), used, |level| {
            let reached = (0..).map(|q| f64::from(q) / 50.0).take_while(|x| chi_square_cdf(dof, *x) <= level);
            let p = reached.last().map_or(0.0, |x| cells.at_most(x));
            vec![Tail { count: 1, sum: p, squares: p * p }]
        })
    };
    vec![row(17, false), row(33, true), row(65, true)]
}

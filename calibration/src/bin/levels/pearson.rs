//! Pearson's chi-square: equal cells, and one light cell among heavy ones.

use crate::Effort;
use crate::table::Row;
use freepath_calibration::multinomial::Multinomial;
use freepath_statistics::hypothesis::least_expected;

/// Cells of so many expected draws, with a light one.
fn cells(count: usize, each: f64, light: f64) -> Vec<f64> {
    let mut all = vec![each; count - 1];
    all.push(light);
    all
}

pub(crate) fn rows(effort: Effort) -> Vec<Row> {
    let row = |test: &'static str, count: usize, each: f64, light: f64| {
        let setting = format!("{count} cells expecting {each:.0}, one of them {light:.0}");
        let used = each >= least_expected(count) && light >= least_expected(count);
        let law = Multinomial::expecting(&cells(count, each, light));
        let fewer = if count > 100 { effort.replicates / 8 } else { effort.replicates };
        Row::new(test, setting, used, |level| vec![law.level(level, effort.seed, fewer)])
    };
    let mut rows = Vec::new();
    for (test, count) in [("chi_square_16", 17), ("chi_square_64", 65), ("chi_square_fine", 500)] {
        let light = least_expected(count);
        rows.extend([row(test, count, light, light), row(test, count, 20.0 * light, light)]);
        rows.push(row(test, count, 10.0, 10.0));
    }
    for count in [2, 3, 5, 9, 15, 16] {
        let light = least_expected(count);
        rows.extend([row("coleman", count, light, light), row("coleman", count, 1000.0 * light, light)]);
    }
    rows.push(row("coleman", 2, 5e4, 50.0));
    rows
}

//! A medium as a table of t and mu, for programs that read no volumes.
//!
//! ```text
//! rows per cell n: 2 where mu is constant or linear between breaks, 4 where it is a cubic
//! row k of a cell: t = start + (end - start) k / (n - 1), mu the limit from within the cell
//! ```
//!
//! The polynomial through the n rows of a cell is mu: the table is exact up to rounding, jumps included. There is no table of a
//! medium that is curved between its breaks.

use freepath_estimators::{Cells, Medium};
use std::io::{self, BufWriter, Write};
use tempfile::NamedTempFile;

/// Rows per cell, and the coefficients that each takes of the values inside the cell, at the middle of so many equal parts.
type Rule = (usize, &'static [&'static [f64]]);

/// Lagrange's polynomials: through one point; through 1/4, 3/4; through 1/8, 3/8, 5/8, 7/8.
fn rule(cells: Cells) -> Option<Rule> {
    match cells {
        Cells::Constant => Some((2, &[&[1.0], &[1.0]])),
        Cells::Linear => Some((2, &[&[1.5, -0.5], &[-0.5, 1.5]])),
        Cells::Cubic => Some((4, CUBIC)),
        Cells::Curved => None,
    }
}

/// At 0, 1/3, 2/3 and 1; the first in units of 1/16, the second of 1/1296.
const CUBIC: &[&[f64]] = &[
    &[35.0 / 16.0, -35.0 / 16.0, 21.0 / 16.0, -5.0 / 16.0],
    &[91.0 / 1296.0, 1365.0 / 1296.0, -195.0 / 1296.0, 35.0 / 1296.0],
    &[35.0 / 1296.0, -195.0 / 1296.0, 1365.0 / 1296.0, 91.0 / 1296.0],
    &[-5.0 / 16.0, 21.0 / 16.0, -35.0 / 16.0, 35.0 / 16.0],
];

/// The table in a file of its own, removed with it, and its rows per cell; none of a curved medium.
pub(super) fn write(medium: &dyn Medium) -> io::Result<Option<(NamedTempFile, usize)>> {
    let Some((rows, _)) = rule(medium.cells()) else { return Ok(None) };
    let file = tempfile::Builder::new().prefix("freepath-").suffix(".csv").tempfile()?;
    let mut out = BufWriter::new(file.as_file());
    rows_to(medium, &mut out)?;
    out.flush()?;
    drop(out);
    Ok(Some((file, rows)))
}

/// Writes the table.
fn rows_to(medium: &dyn Medium, out: &mut dyn Write) -> io::Result<()> {
    let Some((rows, weights)) = rule(medium.cells()) else { return Ok(()) };
    writeln!(out, "t,mu")?;
    let mut start = 0.0;
    for &end in medium.breaks().iter().chain([&medium.length()]) {
        let (inside, width) = (weights[0].len(), end - start);
        let at = |i: usize| medium.mu(start + width * (2 * i + 1) as f64 / (2 * inside) as f64);
        let values: Vec<f64> = (0..inside).map(at).collect();
        for (k, weights) in weights.iter().enumerate() {
            let t = if k + 1 == rows { end } else { start + width * k as f64 / (rows - 1) as f64 };
            let mu: f64 = weights.iter().zip(&values).map(|(weight, value)| weight * value).sum();
            writeln!(out, "{t},{}", if mu < 0.0 { 0.0 } else { mu })?; // rounding alone takes it below 0
        }
        start = end;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_estimators::{Extinction, Majorants};

    /// 1 + t + t^2 + t^3 up to 1, then 7.
    struct Jump;

    impl Extinction for Jump {
        fn length(&self) -> f64 {
            3.0
        }
        fn mu(&self, t: f64) -> f64 {
            if t < 1.0 { 1.0 + t + t * t + t * t * t } else { 7.0 }
        }
        fn majorants(&self) -> &Majorants {
            static NONE: std::sync::LazyLock<Majorants> = std::sync::LazyLock::new(Majorants::default);
            &NONE
        }
        fn breaks(&self) -> &[f64] {
            &[1.0]
        }
        fn cells(&self) -> Cells {
            Cells::Cubic
        }
    }

    impl Medium for Jump {
        fn extrema(&self, _: f64, _: f64) -> (f64, f64) {
            (1.0, 7.0)
        }
    }

    #[test]
    fn a_table_is_the_medium_with_both_sides_of_its_jumps() {
        let mut text = Vec::new();
        rows_to(&Jump, &mut text).unwrap();
        let text = String::from_utf8(text).unwrap();
        let rows: Vec<(f64, f64)> = text
            .lines()
            .skip(1)
            .map(|line| line.split_once(',').map(|(t, mu)| (t.parse().unwrap(), mu.parse().unwrap())).unwrap())
            .collect();
        assert_eq!(rows.len(), 8);
        for (i, &(t, mu)) in rows.iter().enumerate() {
            let right = if i < 4 { 1.0 + t + t * t + t * t * t } else { 7.0 };
            assert!((mu - right).abs() < 1e-14, "{t} {mu} {right}");
        }
        let ends = [rows[3].0, rows[4].0, rows[7].0];
        assert_eq!(ends.map(f64::to_bits), [1.0, 1.0, 3.0].map(f64::to_bits));
    }
}

//! Media that are polynomials between their breaks: a cell from break to break, and mu exact up to rounding.

use super::cell::Cell;
use freepath_estimators::Medium;

/// For each row of a cell the coefficients that it takes of mu inside the cell, at the middle of so many equal parts: Lagrange's
/// polynomial, which reaches the limit at a jump from within.
pub(super) type Rule = &'static [&'static [f64]];

/// Through one point.
pub(super) const CONSTANT: Rule = &[&[1.0], &[1.0]];

/// Through 1/4 and 3/4: at 0 and 1.
pub(super) const LINEAR: Rule = &[&[1.5, -0.5], &[-0.5, 1.5]];

/// Through 1/8, 3/8, 5/8 and 7/8: at 0, 1/3, 2/3 and 1; the first in units of 1/16, the second of 1/1296.
pub(super) const CUBIC: Rule = &[
    &[35.0 / 16.0, -35.0 / 16.0, 21.0 / 16.0, -5.0 / 16.0],
    &[91.0 / 1296.0, 1365.0 / 1296.0, -195.0 / 1296.0, 35.0 / 1296.0],
    &[35.0 / 1296.0, -195.0 / 1296.0, 1365.0 / 1296.0, 91.0 / 1296.0],
    &[-5.0 / 16.0, 21.0 / 16.0, -35.0 / 16.0, 35.0 / 16.0],
];

/// The cells of `medium`, each as `rule` says.
pub(super) fn cells(medium: &dyn Medium, rule: Rule) -> impl Iterator<Item = Cell> + '_ {
    let ends = medium.breaks().iter().copied().chain([medium.length()]);
    ends.scan(0.0, move |start, end| {
        let cell = cell(medium, rule, *start, end);
        *start = end;
        Some(cell)
    })
}

fn cell(medium: &dyn Medium, rule: Rule, start: f64, end: f64) -> Cell {
    let inside = rule[0].len();
    let at = |i: usize| medium.mu(start + (end - start) * (2 * i + 1) as f64 / (2 * inside) as f64);
    let values: Vec<f64> = (0..inside).map(at).collect();
    let row = |coefficients: &&[f64]| {
        let mu: f64 = coefficients.iter().zip(&values).map(|(coefficient, value)| coefficient * value).sum();
        if mu < 0.0 { 0.0 } else { mu } // rounding alone takes it below 0
    };
    Cell { start, end, mu: rule.iter().map(row).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_estimators::{Cells, Extinction, Majorants};

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
        let rows: Vec<(f64, f64)> = cells(&Jump, CUBIC).flat_map(|cell| cell.rows().collect::<Vec<_>>()).collect();
        assert_eq!(rows.len(), 8);
        for (i, &(t, mu)) in rows.iter().enumerate() {
            let right = if i < 4 { 1.0 + t + t * t + t * t * t } else { 7.0 };
            assert!((mu - right).abs() < 1e-14, "{t} {mu} {right}");
        }
        let ends = [rows[3].0, rows[4].0, rows[7].0];
        assert_eq!(ends.map(f64::to_bits), [1.0, 1.0, 3.0].map(f64::to_bits));
    }
}

//! A medium as a table of t and mu, for programs, which know no formula and read no volume.
//!
//! ```text
//! rows per cell n: 2 where mu is constant or linear between breaks, 4 where it is a cubic, 8 where it is curved
//! row k of a cell: t = start + (end - start) k / (n - 1), mu the limit from within the cell
//! ```
//!
//! The polynomial through the n rows of a cell is mu, jumps included: up to rounding where mu is such a polynomial, and elsewhere
//! with an error of the optical depth that is stated and below what any number of draws could see.

mod cell;
mod curved;
mod newton;
mod polynomial;

use cell::Cell;
use freepath_estimators::{Cells, Medium};
use freepath_formats::Refusal;
use std::io::{self, BufWriter, Write};
use tempfile::NamedTempFile;

/// A table in a file of its own, removed with it.
pub(super) struct NodeTable {
    pub(super) file: NamedTempFile,
    pub(super) rows_per_cell: usize,
    /// The most by which its optical depth may be off beyond rounding.
    pub(super) error: f64,
}

impl NodeTable {
    /// The table of `medium`.
    ///
    /// # Errors
    /// If too many cells would be needed, or the file cannot be written.
    pub(super) fn write(medium: &dyn Medium) -> Result<Self, Refusal> {
        let (rule, exact) = (medium.cells(), |rule| (saved(polynomial::cells(medium, rule)), rule.len(), 0.0));
        let (file, rows_per_cell, error) = match rule {
            Cells::Constant => exact(polynomial::CONSTANT),
            Cells::Linear => exact(polynomial::LINEAR),
            Cells::Cubic => exact(polynomial::CUBIC),
            Cells::Curved => {
                let fit = curved::fit(medium)?;
                (saved(fit.cells.into_iter()), curved::ROWS, fit.error)
            }
        };
        let cannot = |why: io::Error| Refusal::new(format!("its table cannot be written: {why}"), "room for it");
        Ok(Self { file: file.map_err(cannot)?, rows_per_cell, error })
    }
}

fn saved(cells: impl Iterator<Item = Cell>) -> io::Result<NamedTempFile> {
    let file = tempfile::Builder::new().prefix("freepath-").suffix(".csv").tempfile()?;
    let mut out = BufWriter::new(file.as_file());
    writeln!(out, "t,mu")?;
    for cell in cells {
        cell.rows().try_for_each(|(t, mu)| writeln!(out, "{t},{mu}"))?;
    }
    out.flush()?;
    drop(out);
    Ok(file)
}

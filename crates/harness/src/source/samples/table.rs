//! Numbers in rows and columns, read from the first row on.

use super::Refusal;

/// The columns that are wanted of a file, row by row.
pub(crate) trait Table: Send {
    /// Writes the next rows, at most `rows`, into the beginning of each column, and says how many there were.
    fn read(&mut self, rows: usize, columns: &mut [&mut [f64]]) -> Result<usize, Refusal>;
}

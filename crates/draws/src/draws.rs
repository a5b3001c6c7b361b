//! A block of draws.

use crate::column::{self, Column, ColumnKind};
use crate::row::Row;
use numbers::Stored;

mod missing;
mod numbers;

pub use missing::MissingColumn;
pub use numbers::{Numbers, NumbersMut};

/// The columns of one block: row `i` is the `i`-th draw *started*. A column that is not in the [`Row`] costs nothing.
///
/// ```
/// use freepath_draws::{Draws, Row, column};
///
/// let mut draws = Draws::new(&Row::new().with_f64(column::T), 4);
/// draws.f64_mut(column::T)?.fill(0.5);
/// assert_eq!(draws.f64("t")?, [0.5; 4]);
///
/// let error = draws.f64("weight").unwrap_err();
/// assert_eq!(
///     error.to_string(),
///     "cannot find the column `weight` of type f64: the draws have no such column (t: f64)"
/// );
/// # Ok::<(), freepath_draws::MissingColumn>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Draws {
    row: Row,
    rows: usize,
    columns: Vec<Stored>,
}

/// The columns of a block, and their length.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shape {
    row: Row,
    rows: usize,
}

impl Draws {
    /// A block of `rows` draws that nobody has written yet.
    #[must_use]
    pub fn new(row: &Row, rows: usize) -> Self {
        let columns = row.columns().iter().map(|column| Stored::blank(column.kind(), rows)).collect();
        Self { row: row.clone(), rows, columns }
    }

    /// The layout.
    #[must_use]
    pub fn row(&self) -> &Row {
        &self.row
    }

    /// The number of draws in the block.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Layout and length: another afterwards is a block that somebody has replaced.
    #[must_use]
    pub fn shape(&self) -> Shape {
        Shape { row: self.row.clone(), rows: self.rows }
    }

    /// Makes room for `rows` draws; those that are new are not written.
    pub fn resize(&mut self, rows: usize) {
        self.rows = rows;
        self.columns.iter_mut().for_each(|column| column.resize(rows));
    }

    /// Forgets every draw, so that none of an earlier block may stand in for one that is not written.
    pub fn blank(&mut self) {
        self.columns.iter_mut().for_each(Stored::fill_blank);
    }

    /// The numbers of column `name`.
    ///
    /// # Errors
    /// If there is no such column of numbers.
    pub fn f64(&self, name: &str) -> Result<&[f64], MissingColumn> {
        match self.named(name) {
            Some(Stored::F64(numbers)) => Ok(numbers),
            Some(Stored::U32(_)) | None => Err(missing(&self.row, name, ColumnKind::F64)),
        }
    }

    /// The counts of column `name`.
    ///
    /// # Errors
    /// If there is no such column of counts.
    pub fn u32(&self, name: &str) -> Result<&[u32], MissingColumn> {
        match self.named(name) {
            Some(Stored::U32(counts)) => Ok(counts),
            Some(Stored::F64(_)) | None => Err(missing(&self.row, name, ColumnKind::U32)),
        }
    }

    /// The numbers of column `name`, to be written.
    ///
    /// # Errors
    /// If there is no such column of numbers.
    pub fn f64_mut(&mut self, name: &str) -> Result<&mut [f64], MissingColumn> {
        match self.row.position(name).map(|at| &mut self.columns[at]) {
            Some(Stored::F64(numbers)) => Ok(numbers),
            Some(Stored::U32(_)) | None => Err(missing(&self.row, name, ColumnKind::F64)),
        }
    }

    /// The counts of column `name`, to be written.
    ///
    /// # Errors
    /// If there is no such column of counts.
    pub fn u32_mut(&mut self, name: &str) -> Result<&mut [u32], MissingColumn> {
        match self.row.position(name).map(|at| &mut self.columns[at]) {
            Some(Stored::U32(counts)) => Ok(counts),
            Some(Stored::F64(_)) | None => Err(missing(&self.row, name, ColumnKind::U32)),
        }
    }

    /// The weights of each channel.
    ///
    /// # Errors
    /// If there are none of channel 0.
    pub fn channels(&self) -> Result<Vec<&[f64]>, MissingColumn> {
        let first = self.f64(&column::channel(0))?;
        let later = (1..).map_while(|k| self.f64(&column::channel(k)).ok());
        Ok(std::iter::once(first).chain(later).collect())
    }

    /// All columns, in the order of the row.
    pub fn columns(&self) -> impl Iterator<Item = (&Column, Numbers<'_>)> {
        self.row.columns().iter().zip(self.columns.iter().map(Stored::view))
    }

    /// All columns, in the order of the row, to be written.
    pub fn columns_mut(&mut self) -> impl Iterator<Item = (&Column, NumbersMut<'_>)> {
        self.row.columns().iter().zip(self.columns.iter_mut().map(Stored::view_mut))
    }

    fn named(&self, name: &str) -> Option<&Stored> {
        self.row.position(name).map(|at| &self.columns[at])
    }
}

fn missing(row: &Row, name: &str, kind: ColumnKind) -> MissingColumn {
    MissingColumn::new(Column::new(name.to_owned(), kind), row.clone())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_nobody_wrote_is_blank() {
        let mut draws = Draws::new(&Row::new().with_f64("a").with_u32("b"), 2);
        draws.u32_mut("b").unwrap().fill(7);
        draws.f64_mut("a").unwrap().fill(7.0);
        draws.resize(3);
        assert_eq!(draws.u32("b").unwrap(), [7, 7, 0]);
        assert!(draws.f64("a").unwrap()[2].is_nan());
        draws.blank();
        assert_eq!(draws.u32("b").unwrap(), [0; 3]);
        assert!(draws.f64("a").unwrap().iter().all(|x| x.is_nan()));
    }

    #[test]
    fn a_column_of_another_name_or_type_is_missing() {
        let mut draws = Draws::new(&Row::new().with_f64("a").with_u32("b"), 2);
        let words = [draws.f64("b").unwrap_err().to_string(), draws.f64_mut("b").unwrap_err().to_string()];
        let why = "cannot find the column `b` of type f64: the draws have no such column (a: f64, b: u32)";
        assert_eq!(words, [why; 2]);
        assert!(draws.u32("a").is_err() && draws.u32_mut("a").is_err() && draws.channels().is_err());
        let none = Draws::new(&Row::new(), 2).f64("t").unwrap_err().to_string();
        assert_eq!(none, "cannot find the column `t` of type f64: the draws have no columns");
    }

    #[test]
    fn another_layout_or_length_is_another_shape() {
        let row = Row::new().with_channels(2);
        let (draws, again) = (Draws::new(&row, 2), Draws::new(&Row::new().with_channels(2), 2));
        assert_eq!(draws.channels().unwrap().len(), 2);
        assert_eq!(draws.shape(), again.shape());
        assert_ne!(draws.shape(), Draws::new(&row, 3).shape());
        assert_ne!(draws.shape(), Draws::new(&row.with_u32("b"), 2).shape());
    }
}

use crate::column::Column;
use crate::row::Row;
use std::fmt;

/// A column that was asked for and is not there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MissingColumn {
    wanted: Column,
    row: Row,
}

impl MissingColumn {
    pub(crate) fn new(wanted: Column, row: Row) -> Self {
        Self { wanted, row }
    }

    /// The column that was asked for.
    #[must_use]
    pub fn wanted(&self) -> &Column {
        &self.wanted
    }
}

impl fmt::Display for MissingColumn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { wanted, row } = self;
        write!(f, "cannot find the column `{}` of type {}: ", wanted.name(), wanted.kind())?;
        if row.columns().is_empty() {
            return write!(f, "the draws have no columns");
        }
        write!(f, "the draws have no such column ({row})")
    }
}

impl std::error::Error for MissingColumn {}

//! The layout of a block.

use crate::column::{self, Column, ColumnKind};
use std::borrow::Cow;
use std::fmt;
use std::sync::Arc;

/// The columns of a block, in the order of files and programs. A clone shares them.
///
/// ```
/// use freepath_draws::{Row, column};
///
/// let row = Row::new().with_f64(column::T).with_u32(column::COLLISIONS);
/// assert_eq!(row.to_string(), "t: f64, collisions: u32");
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Row {
    columns: Arc<[Column]>,
}

impl Row {
    /// No column.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The same with a column of numbers at the end.
    #[must_use]
    pub fn with_f64(self, name: impl Into<Cow<'static, str>>) -> Self {
        self.with(Column::new(name, ColumnKind::F64))
    }

    /// The same with a column of counts at the end.
    #[must_use]
    pub fn with_u32(self, name: impl Into<Cow<'static, str>>) -> Self {
        self.with(Column::new(name, ColumnKind::U32))
    }

    /// The same with a column of weights for each of `channels` channels.
    #[must_use]
    pub fn with_channels(self, channels: usize) -> Self {
        (0..channels).fold(self, |row, k| row.with_f64(column::channel(k)))
    }

    /// A name stands for one column: one that is there already is replaced in its place.
    fn with(self, column: Column) -> Self {
        let mut columns = self.columns.to_vec();
        match columns.iter_mut().find(|other| other.name() == column.name()) {
            Some(same) => *same = column,
            None => columns.push(column),
        }
        Self { columns: columns.into() }
    }

    /// The columns, in order.
    #[must_use]
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// True if there is a column of this name.
    #[must_use]
    pub fn has(&self, name: &str) -> bool {
        self.position(name).is_some()
    }

    pub(crate) fn position(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|column| column.name() == name)
    }
}

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, column) in self.columns.iter().enumerate() {
            write!(f, "{}{column}", if i > 0 { ", " } else { "" })?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_stands_for_one_column() {
        let row = Row::new().with_u32("a").with_channels(2).with_f64("a");
        assert_eq!(row.to_string(), "a: f64, channel_0: f64, channel_1: f64");
        assert!(row.has("channel_1") && !row.has("channel_2"));
    }
}

//! Numbers in rows and columns: text, arrays, or doubles without a header.

mod binary;
mod file;
mod layout;
mod rows;
#[cfg(test)]
mod tests;
mod text;

use crate::error::Refusal;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use file::TableFile;
pub use rows::read_rows;

/// The columns that are wanted of a table, row by row, from the first row on.
pub trait Table: Send {
    /// Writes the next rows, at most `rows`, into the beginning of each column, and says how many there were.
    ///
    /// # Errors
    /// If the rows end too early or cannot be read: why, and in which line and column.
    fn read(&mut self, rows: usize, columns: &mut [&mut [f64]]) -> Result<usize, Refusal>;
}

/// The format of a file of samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Format {
    /// An array of NumPy, float32 or float64, of either byte order, one- or two-dimensional.
    Npy,
    /// Text, columns separated by commas.
    Csv,
    /// Text, columns separated by blanks; lines that begin with # are left out.
    Txt,
    /// Doubles without a header, little endian.
    F64,
}

/// The columns wanted of a table, and its format.
pub struct TableRequest<'a> {
    /// Its format; none for what the ending of a file's name tells, or for doubles on a stream.
    pub format: Option<Format>,
    /// Numbers in a row, at least 1, of a table that does not say it: doubles without a header.
    pub across: usize,
    /// Finds the columns, in the order in which they are wanted; each below [`Head::across`].
    pub select: &'a dyn Fn(&Head) -> Result<Vec<Selected>, Refusal>,
}

/// A column that is wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Selected {
    /// Its number, from 0.
    pub column: usize,
    /// The words that may stand there in place of a number, where the table is text.
    pub words: &'static [Word],
}

impl Selected {
    /// The numbers of a column.
    #[must_use]
    pub fn numbers(column: usize) -> Self {
        Self { column, words: &[] }
    }
}

/// A word that stands for a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Word {
    /// The word.
    pub word: &'static str,
    /// The number.
    pub number: f64,
}

/// The columns of a table, as far as known before its first row of numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Head {
    names: Vec<String>,
    across: usize,
}

impl Head {
    pub(crate) fn unnamed(across: usize) -> Self {
        Self { names: Vec::new(), across }
    }

    /// The names of the columns; none if its first line is numbers, or it has no lines.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The number of its columns.
    #[must_use]
    pub fn across(&self) -> usize {
        self.across
    }

    /// The column of this name, or of this number from 0.
    ///
    /// # Errors
    /// If there is none, or several have that name.
    pub fn column(&self, name: &str) -> Result<usize, Refusal> {
        let numbered = || name.parse().ok().filter(|&number| number < self.across);
        self.named(name)?.or_else(numbered).ok_or_else(|| {
            let last = self.across.saturating_sub(1);
            let allowed = format!("a name of its first line, or a number from 0 to {last}");
            Refusal::new(format!("it has no column {name:?}"), allowed)
        })
    }

    /// The column of this name, if there is one.
    ///
    /// # Errors
    /// If there are several.
    pub fn named(&self, name: &str) -> Result<Option<usize>, Refusal> {
        let mut named = (0..self.names.len()).filter(|&i| self.names[i] == name);
        match (named.next(), named.count()) {
            (first, 0) => Ok(first),
            (_, more) => {
                let cause = format!("it has {} columns {name:?}", more + 1);
                Err(Refusal::new(cause, "different names, or a number from 0"))
            }
        }
    }
}

//! The layout of the rows of a table, and the columns that are wanted.

use super::binary::{Binary, Cell};
use super::text::Text;
use super::{Format, Head, Selected, Table, TableRequest};
use crate::error::Refusal;
use crate::npy::Header;
use crate::open::{Regular, foreign_to_doubles, head};
use std::io::{Cursor, ErrorKind, Read, Seek, SeekFrom};
use std::path::Path;

/// The most numbers in a row.
const MOST_ACROSS: u64 = 4096;
/// Rows that are passed over at a time.
const PART: usize = 16_384;
/// The types that an array of rows may hold.
const TYPES: &str = "float32 or float64, little or big endian";

#[derive(Clone, Debug)]
pub(super) enum Layout {
    /// After so many bytes, rows of so many numbers.
    Binary { cell: Cell, start: u64, across: usize, selected: Vec<Selected> },
    /// As text.
    Text { format: Format, selected: Vec<Selected> },
}

impl Layout {
    pub(super) fn single(&self) -> bool {
        matches!(self, Self::Binary { cell: Cell { single: true, .. }, .. })
    }

    pub(super) fn is_text(&self) -> bool {
        matches!(self, Self::Text { .. })
    }

    /// The table of an input that stands at its first row, or, for text, at its beginning.
    fn table(&self, input: Box<dyn Read + Send>) -> Result<Box<dyn Table>, Refusal> {
        match self.clone() {
            Self::Binary { cell, across, selected, .. } => {
                Ok(Box::new(Binary { input, cell, across, selected, bytes: Vec::new() }))
            }
            Self::Text { format, selected } => Ok(Box::new(Text::new(input, format, &|_| Ok(selected.clone()))?)),
        }
    }

    /// A table of the file that stands at `row`.
    pub(super) fn reopen(&self, path: &Path, row: u64) -> Result<Box<dyn Table>, Refusal> {
        let Regular { mut file, .. } = Regular::open(path)?;
        if let Self::Binary { cell, start, across, .. } = self {
            file.seek(SeekFrom::Start(start + row * (across * cell.width()) as u64))?;
            return self.table(Box::new(file));
        }
        let mut table = self.table(Box::new(file))?;
        let mut left = row;
        while left > 0 {
            let rows = if left < PART as u64 { left as usize } else { PART };
            left -= match table.read(rows, &mut [])? {
                0 => return Err(Refusal::new("it has become shorter", "a file that nobody writes to")),
                read => read as u64,
            };
        }
        Ok(table)
    }

    /// The number of rows of a file of `size` bytes, which must be those that its header tells, if it does; none for text.
    pub(super) fn whole(&self, rows: Option<u64>, size: u64) -> Result<Option<u64>, Refusal> {
        let Self::Binary { cell, start, across, .. } = self else { return Ok(None) };
        let (held, row) = (size.saturating_sub(*start), (across * cell.width()) as u64);
        match rows {
            None if held.is_multiple_of(row) => Ok(Some(held / row)),
            None => Err(Refusal::new(
                format!("its {held} bytes are no whole number of rows"),
                format!("rows of {row} bytes"),
            )),
            Some(rows) if rows.checked_mul(row) == Some(held) => Ok(Some(rows)),
            Some(rows) => {
                let cause = format!("it holds {held} bytes of values where its shape needs {rows} times {row}");
                Err(Refusal::new(cause, "one whole array and nothing more"))
            }
        }
    }
}

/// A table whose beginning has been read.
pub(super) struct Begun {
    pub(super) layout: Layout,
    pub(super) table: Box<dyn Table>,
    /// Rows, if the header tells.
    pub(super) rows: Option<u64>,
}

impl Begun {
    pub(super) fn new(
        mut input: Box<dyn Read + Send>,
        format: Format,
        wanted: &TableRequest,
    ) -> Result<Self, Refusal> {
        let (layout, rows) = match format {
            Format::Npy => npy(&Header::read(&mut input, TYPES)?, wanted)?,
            Format::F64 => {
                input = begun_doubles(input)?;
                let (cell, across) = (Cell { single: false, big_endian: false }, wanted.across);
                let selected = (wanted.select)(&Head::unnamed(across))?;
                (Layout::Binary { cell, start: 0, across, selected }, None)
            }
            Format::Csv | Format::Txt => {
                let text = Text::new(input, format, wanted.select)?;
                let layout = Layout::Text { format, selected: text.selected().to_vec() };
                return Ok(Self { layout, table: Box::new(text), rows: None });
            }
        };
        let table = layout.table(input)?;
        Ok(Self { layout, table, rows })
    }
}

/// Rows and columns of an array.
fn npy(header: &Header, wanted: &TableRequest) -> Result<(Layout, Option<u64>), Refusal> {
    let wrong = |cause: String| Err(Refusal::new(cause, "a list, or a table [draw][column] in C order"));
    let (rows, across) = match header.shape[..] {
        [rows] => (rows, 1),
        [_, _] if header.fortran => return wrong("its array is in Fortran order".into()),
        [rows, across] => (rows, across),
        _ => return wrong(format!("its array has {} dimensions", header.shape.len())),
    };
    let Some(cell) = Cell::of(header.encoding) else {
        return Err(Refusal::new("its values are whole numbers", TYPES));
    };
    if across > MOST_ACROSS {
        let allowed = format!("a row for each draw, of at most {MOST_ACROSS} columns");
        return Err(Refusal::new("its array has too many columns", allowed));
    }
    let across = across as usize;
    let selected = (wanted.select)(&Head::unnamed(across))?;
    Ok((Layout::Binary { cell, start: header.start, across, selected }, Some(rows)))
}

/// Doubles without a header, from the first on, unless their first bytes are those of another format. An input that cannot be read
/// says so where its rows are read, as it would without this look.
fn begun_doubles(mut input: Box<dyn Read + Send>) -> Result<Box<dyn Read + Send>, Refusal> {
    let head = match head(&mut input) {
        Ok(head) => head,
        Err(why) => return Ok(Box::new(Broken(why.kind(), why.to_string()))),
    };
    match foreign_to_doubles(&head) {
        Some(refusal) => Err(refusal),
        None => Ok(Box::new(Cursor::new(head).chain(input))),
    }
}

/// An input whose every read fails: its kind of error, in words.
struct Broken(ErrorKind, String);

impl Read for Broken {
    fn read(&mut self, _: &mut [u8]) -> std::io::Result<usize> {
        Err(std::io::Error::new(self.0, self.1.clone()))
    }
}

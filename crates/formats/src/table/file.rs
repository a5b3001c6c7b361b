//! A table that is read in parts, and where its readers stand.

use super::layout::{Begun, Layout};
use super::{Format, Table, TableRequest};
use crate::error::{ReadError, Refusal};
use crate::open::{Regular, foreign, head};
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// A table in a file, whose rows can be read from any one on, or on a stream, where they come once.
pub struct TableFile {
    /// None for a stream.
    path: Option<PathBuf>,
    layout: Layout,
    /// None where only reading it through tells.
    rows: Option<u64>,
    /// So that text is not read twice, and a stream, which cannot be, can be read on.
    parked: Mutex<Option<Parked>>,
}

/// A reader that nobody reads from.
struct Parked {
    /// The row at which it stands.
    row: u64,
    table: Box<dyn Table>,
}

impl TableFile {
    /// The table in the file `path`.
    ///
    /// # Errors
    /// If the file is not regular, empty, not what its format says, cut short, or has no such columns. Text is looked at no
    /// further than its first row.
    pub fn open(path: &Path, wanted: &TableRequest) -> Result<Self, ReadError> {
        let begin = || {
            let Regular { mut file, size } = Regular::open(path)?;
            let format = wanted.format.map_or_else(|| by_ending(path, &mut file), Ok)?;
            let begun = Begun::new(Box::new(file), format, wanted)?;
            let rows = begun.layout.whole(begun.rows, size)?;
            Ok(Self::begun(Some(path), begun, rows))
        };
        begin().map_err(|refusal| ReadError::new(path, refusal))
    }

    /// The table that `input` gives, once.
    ///
    /// # Errors
    /// If the input does not begin as its format says, or has no such columns.
    pub fn stream(input: Box<dyn Read + Send>, wanted: &TableRequest) -> Result<Self, ReadError> {
        let begun = Begun::new(input, wanted.format.unwrap_or(Format::F64), wanted);
        let begun = begun.map_err(|refusal| ReadError::new(shown(None), refusal))?;
        let rows = begun.rows;
        Ok(Self::begun(None, begun, rows))
    }

    fn begun(path: Option<&Path>, begun: Begun, rows: Option<u64>) -> Self {
        let Begun { layout, table, .. } = begun;
        let parked = Mutex::new(Some(Parked { row: 0, table }));
        Self { path: path.map(Path::to_path_buf), layout, rows, parked }
    }

    /// The number of rows; none where only reading it through tells, as of text.
    #[must_use]
    pub fn rows(&self) -> Option<u64> {
        self.rows
    }

    /// The numbers are stored in single precision.
    #[must_use]
    pub fn is_single(&self) -> bool {
        self.layout.single()
    }

    /// True if the numbers are written as text.
    #[must_use]
    pub fn is_text(&self) -> bool {
        self.layout.is_text()
    }

    /// A reader that stands at `row`.
    ///
    /// # Errors
    /// If the file cannot be opened again, has become shorter, or is a stream that has gone on.
    pub fn reader(&self, row: u64) -> Result<Box<dyn Table>, Refusal> {
        let mut parked = self.parked.lock().unwrap_or_else(PoisonError::into_inner);
        match (parked.take_if(|parked| parked.row == row), &self.path) {
            (Some(there), _) => Ok(there.table),
            (None, None) => Err(Refusal::new("it cannot be read twice", "save it in a file")),
            (None, Some(path)) => self.layout.reopen(path, row),
        }
    }

    /// Gives a reader back, which now stands at `row`, for whoever reads on from there.
    pub fn park(&self, row: u64, table: Box<dyn Table>) {
        *self.parked.lock().unwrap_or_else(PoisonError::into_inner) = Some(Parked { row, table });
    }

    /// The refusal of this file.
    #[must_use]
    pub fn error(&self, refusal: Refusal) -> ReadError {
        ReadError::new(shown(self.path.as_deref()), refusal)
    }
}

fn shown(path: Option<&Path>) -> &Path {
    path.unwrap_or(Path::new("standard input"))
}

/// The format that the ending of the name tells; where it tells none, the first bytes may tell what else the file is.
fn by_ending(path: &Path, file: &mut dyn Read) -> Result<Format, Refusal> {
    match path.extension().unwrap_or_default().to_ascii_lowercase().to_str() {
        Some("f64") => Ok(Format::F64),
        Some("npy") => Ok(Format::Npy),
        Some("csv") => Ok(Format::Csv),
        Some("txt") => Ok(Format::Txt),
        Some(_) | None => Err(foreign(&head(file)?).unwrap_or_else(unnamed)),
    }
}

fn unnamed() -> Refusal {
    let allowed = ".npy, .csv, .txt or .f64, not compressed, or a stated `format`";
    Refusal::new("its name does not tell its format", allowed)
}

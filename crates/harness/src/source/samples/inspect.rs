//! What is known of a file before its draws are judged: how it is written, which columns are wanted, how many rows it has.

use super::super::npy::Header;
use super::super::open_regular;
use super::super::stored::Number;
use super::binary::{Binary, Cell};
use super::meaning::Meaning;
use super::text::Text;
use super::{BLOCK, Format, Refusal, Request, SINGLE_TOLERANCE, SampleFile, Table};
use crate::samples::SampleKind;
use freepath_draws::{Draws, Row, column};
use std::io::{Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// The most numbers in a row.
const MOST_ACROSS: u64 = 4096;

/// What an array of samples may hold.
const TYPES: &str = "float32 or float64, little or big endian";

/// How the rows are written, and which columns are wanted.
#[derive(Clone, Debug)]
pub(super) enum Layout {
    /// After so many bytes, rows of so many numbers.
    Binary { cell: Cell, start: u64, across: usize, wanted: Vec<usize> },
    /// As text.
    Text { format: Format, wanted: Vec<usize>, event: Option<usize> },
}

impl Layout {
    pub(super) fn single(&self) -> bool {
        matches!(self, Self::Binary { cell: Cell { single: true, .. }, .. })
    }

    /// The table of an input that stands at its first row, or, for text, at its beginning.
    fn table(&self, input: Box<dyn Read + Send>) -> Result<Box<dyn Table>, Refusal> {
        match self.clone() {
            Self::Binary { cell, across, wanted, .. } => {
                Ok(Box::new(Binary { input, cell, across, wanted, bytes: Vec::new() }))
            }
            Self::Text { format, wanted, event } => {
                Ok(Box::new(Text::new(input, format, |_, _| Ok((wanted, event)))?))
            }
        }
    }

    /// A table of the file that stands at `row`.
    pub(super) fn reopen(&self, path: &Path, row: u64) -> Result<Box<dyn Table>, Refusal> {
        let (mut file, _) = open_regular(path)?;
        if let Self::Binary { cell, start, across, .. } = self {
            file.seek(SeekFrom::Start(start + row * (across * cell.width()) as u64))?;
            return self.table(Box::new(file));
        }
        let mut table = self.table(Box::new(file))?;
        let mut left = row;
        while left > 0 {
            let rows = if left < BLOCK as u64 { left as usize } else { BLOCK };
            left -= match table.read(rows, &mut [])? {
                0 => return Err(Refusal::new("it has become shorter", "a file that nobody writes to")),
                read => read as u64,
            };
        }
        Ok(table)
    }
}

/// Begins to read what can be read only once.
pub(super) fn stream(input: Box<dyn Read + Send>, request: &Request) -> Result<SampleFile, Refusal> {
    let unknown = || Refusal::new("the number of draws is not known", "state `--draws`");
    let rows = request.draws.ok_or_else(unknown)?;
    let begun = begin(input, request.format.unwrap_or(Format::F64), request)?;
    enough(begun.rows.unwrap_or(rows), rows)?;
    Ok(begun.file(None, request, rows, 0))
}

/// Opens a file.
pub(super) fn open(path: &Path, request: &Request) -> Result<SampleFile, Refusal> {
    let format = format(path, request)?;
    let (file, size) = open_regular(path)?;
    let mut begun = begin(Box::new(file), format, request)?;
    let held = match &begun.layout {
        Layout::Binary { cell, start, across, .. } => {
            whole(begun.rows, size.saturating_sub(*start), (across * cell.width()) as u64)?
        }
        Layout::Text { .. } => scan(&mut begun, request)?,
    };
    if held == 0 {
        return Err(Refusal::new("it holds no draw", "at least 1 draw"));
    }
    let rows = request.draws.unwrap_or(held);
    enough(held, rows)?;
    Ok(begun.file(Some(path.to_path_buf()), request, rows, held - rows))
}

fn enough(held: u64, rows: u64) -> Result<(), Refusal> {
    match held < rows {
        true => Err(Refusal::new(format!("it holds {held} draws, not {rows}"), "as many as are asked for")),
        false => Ok(()),
    }
}

/// What the ending of the name tells, unless the format is stated.
fn format(path: &Path, request: &Request) -> Result<Format, Refusal> {
    let told = match path.extension().unwrap_or_default().to_ascii_lowercase().to_str() {
        Some("f64") => Some(Format::F64),
        Some("npy") => Some(Format::Npy),
        Some("csv") => Some(Format::Csv),
        Some("txt") => Some(Format::Txt),
        _ => None,
    };
    let unknown = || {
        Refusal::new(
            "its name does not tell its format",
            ".npy, .csv, .txt or .f64, not compressed, or a stated `format`",
        )
    };
    request.format.or(told).ok_or_else(unknown)
}

/// A file whose beginning has been read.
struct Begun {
    layout: Layout,
    /// Where it stands; none once it has been read through.
    table: Option<Box<dyn Table>>,
    /// Rows, if the header tells.
    rows: Option<u64>,
}

impl Begun {
    fn file(self, path: Option<PathBuf>, request: &Request, rows: u64, left: u64) -> SampleFile {
        let implied = if self.layout.single() { SINGLE_TOLERANCE } else { 0.0 };
        let meaning = Meaning::new(request, request.tolerance.unwrap_or(implied));
        let parked = Mutex::new(self.table.map(|table| (0, table)));
        SampleFile { path, layout: self.layout, meaning, rows, left, parked }
    }
}

fn begin(mut input: Box<dyn Read + Send>, format: Format, request: &Request) -> Result<Begun, Refusal> {
    let (layout, rows) = match format {
        Format::Npy => npy(&Header::read(&mut input, TYPES)?, request)?,
        Format::F64 => {
            let across = if request.kind == SampleKind::Chromatic { 2 + request.channels } else { 1 };
            let (wanted, _) = columns(&[], across, request)?;
            let cell = Cell { single: false, big_endian: false };
            (Layout::Binary { cell, start: 0, across, wanted }, None)
        }
        Format::Csv | Format::Txt => {
            let text = Text::new(input, format, |names, across| columns(names, across, request))?;
            let layout = Layout::Text { format, wanted: text.wanted.clone(), event: text.event };
            return Ok(Begun { layout, table: Some(Box::new(text)), rows: None });
        }
    };
    let table = Some(layout.table(input)?);
    Ok(Begun { layout, table, rows })
}

/// Rows and columns of an array.
fn npy(header: &Header, request: &Request) -> Result<(Layout, Option<u64>), Refusal> {
    let wrong = |cause: String| Err(Refusal::new(cause, "a list, or a table [draw][column] in C order"));
    let (rows, across) = match header.shape[..] {
        [rows] => (rows, 1),
        [_, _] if header.fortran => return wrong("its array is in Fortran order".into()),
        [rows, across] => (rows, across),
        _ => return wrong(format!("its array has {} dimensions", header.shape.len())),
    };
    if header.number != Number::Float {
        return Err(Refusal::new("its values are whole numbers", TYPES));
    }
    if across > MOST_ACROSS {
        let allowed = format!("a row for each draw, of at most {MOST_ACROSS} columns");
        return Err(Refusal::new("its array has too many columns", allowed));
    }
    let across = across as usize;
    let (wanted, _) = columns(&[], across, request)?;
    let cell = Cell { single: header.width == 4, big_endian: header.big_endian };
    Ok((Layout::Binary { cell, start: header.start, across, wanted }, Some(rows)))
}

/// The number of rows of `row` bytes in `held` bytes: those that the header tells, if it does.
fn whole(rows: Option<u64>, held: u64, row: u64) -> Result<u64, Refusal> {
    match rows {
        None if held.is_multiple_of(row) => Ok(held / row),
        None => Err(Refusal::new(
            format!("its {held} bytes are no whole number of rows"),
            format!("rows of {row} bytes"),
        )),
        Some(rows) if rows.checked_mul(row) == Some(held) => Ok(rows),
        Some(rows) => {
            let cause = format!("it holds {held} bytes of values where its shape needs {rows} times {row}");
            Err(Refusal::new(cause, "one whole array and nothing more"))
        }
    }
}

/// Reads text through to its end: every mistake is found, and the rows are counted.
fn scan(begun: &mut Begun, request: &Request) -> Result<u64, Refusal> {
    let meaning = Meaning::new(request, 0.0);
    let channels = match request.kind {
        SampleKind::WeightedFreePath => 1,
        SampleKind::FreePath | SampleKind::Transmittance | SampleKind::Chromatic => request.channels,
    };
    let row = Row::new().with_f64(column::T).with_f64(column::WEIGHT).with_channels(channels);
    let mut draws = Draws::new(&row, BLOCK);
    let (mut rows, mut events) = (0, Vec::new());
    while let Some(table) = &mut begun.table {
        match meaning.read(&mut **table, BLOCK, &mut draws, &mut events, rows)? {
            0 => begun.table = None,
            read => rows += read as u64,
        }
    }
    Ok(rows)
}

/// The wanted columns of so many, which may have names; and which of the wanted ones tells an event.
fn columns(names: &[String], across: usize, request: &Request) -> Result<(Vec<usize>, Option<usize>), Refusal> {
    if request.kind == SampleKind::Chromatic {
        return Ok((chromatic(names, across, request.channels)?, Some(1)));
    }
    let draws = match request.column {
        Some(name) => column(names, across, name)?,
        None if across == 1 => 0,
        None => return Err(Refusal::new(format!("it has {across} columns"), "one, or a stated `column`")),
    };
    let weight = request.weight.map(|name| column(names, across, name)).transpose()?;
    Ok(([Some(draws), weight].into_iter().flatten().collect(), None))
}

/// The column of this name, or of this number from 0.
pub(in crate::source) fn column(names: &[String], across: usize, name: &str) -> Result<usize, Refusal> {
    let numbered = || name.parse().ok().filter(|&number| number < across);
    unique(names, name)?.or_else(numbered).ok_or_else(|| {
        let allowed = format!("a name of its first line, or a number from 0 to {}", across.saturating_sub(1));
        Refusal::new(format!("it has no column {name:?}"), allowed)
    })
}

/// The column of this name, if there is one.
pub(in crate::source) fn unique(names: &[String], name: &str) -> Result<Option<usize>, Refusal> {
    let mut named = (0..names.len()).filter(|&i| names[i] == name);
    match (named.next(), named.count()) {
        (first, 0) => Ok(first),
        (_, more) => {
            let cause = format!("it has {} columns {name:?}", more + 1);
            Err(Refusal::new(cause, "different names, or a number from 0"))
        }
    }
}

/// The columns t, event, w0, w1 and so on: by name, or else in this order.
fn chromatic(names: &[String], across: usize, channels: usize) -> Result<Vec<usize>, Refusal> {
    let due: Vec<_> =
        ["t".to_string(), "event".into()].into_iter().chain((0..channels).map(|k| format!("w{k}"))).collect();
    let allowed = format!("t, event, w0 to w{}", channels.saturating_sub(1));
    if names.is_empty() {
        return match across == due.len() {
            true => Ok((0..across).collect()),
            false => Err(Refusal::new(format!("it has {across} columns, not {}", due.len()), allowed)),
        };
    }
    if names.iter().any(|name| *name == format!("w{channels}")) {
        return Err(Refusal::new(
            format!("it has more weights than the {channels} channels of the medium"),
            allowed,
        ));
    }
    let of = |name: &String| {
        let missing = || Refusal::new(format!("it has no column {name:?}"), allowed.clone());
        unique(names, name)?.ok_or_else(missing)
    };
    due.iter().map(of).collect()
}

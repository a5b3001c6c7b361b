//! Draws in a file, or on standard input: read block by block, so that their number does not matter.

use super::row_format::RowFormat;
use super::row_reader::RowReader;
use super::{Rows, SampleSource, Wanted};
use crate::subject::BLOCK;
use freepath_draws::{Draws, Row};
use freepath_formats::{Format, Head, ReadError, Refusal, Table, TableFile, TableRequest};
use std::io::Read;
use std::path::Path;

#[cfg(test)]
mod tests;

/// The tolerance that single precision implies: one rounding, relative.
pub(crate) const SINGLE_TOLERANCE: f64 = 6e-8;

/// A request to a file of samples.
#[derive(Clone, Debug)]
pub struct Request {
    /// The format of its rows.
    pub rows: RowFormat,
    /// The format of the file; none if the ending of its name tells.
    pub format: Option<Format>,
    /// The number of rows to judge, from the first one on; none for all, which standard input cannot.
    pub draws: Option<u64>,
    /// The relative error of a distance; none for what the type of the numbers implies.
    pub tolerance: Option<f64>,
    /// Rows of a group that both stages keep whole; none if rows come one by one.
    pub group: Option<u64>,
}

/// A file of samples: the first third of its rows, in drawing order, is stage 1, and the rest stage 2.
pub struct SampleFile {
    table: TableFile,
    format: RowFormat,
    /// The relative error of a distance.
    rounding: f64,
    /// Rows that are judged.
    rows: u64,
    /// Rows that are not.
    left: u64,
    /// Rows of a group.
    group: u64,
}

impl SampleFile {
    /// The samples in `path`, or on standard input if that is `-`. Text is read through once, so that every mistake in it
    /// is found before any draw is judged.
    ///
    /// # Errors
    /// If the file is not regular, empty, not what its format or `request` says, cut short, or holds text where a number
    /// should be.
    pub fn open(path: &Path, request: &Request) -> Result<Self, ReadError> {
        if path == Path::new("-") {
            return Self::stream(Box::new(std::io::stdin()), request);
        }
        let table = request.table(|wanted| TableFile::open(path, wanted))?;
        let held = match table.rows() {
            Some(rows) => Ok(rows),
            None => table.reader(0).and_then(|mut reader| scan(&mut *reader, &request.rows)),
        };
        let rows = held.and_then(|held| request.judged(held).map(|rows| (rows, held - rows)));
        match rows {
            Ok((rows, left)) => Ok(Self::of(table, request, rows, left)),
            Err(refusal) => Err(table.error(refusal)),
        }
    }

    /// The samples that `input` gives, once: raw doubles unless `request` states a format, and as many as it asks for.
    ///
    /// # Errors
    /// If the input does not begin as its format or `request` says, or the number of draws is not known.
    pub fn stream(input: Box<dyn Read + Send>, request: &Request) -> Result<Self, ReadError> {
        let unknown = || {
            let refusal = Refusal::new("the number of draws is not known", "state `--draws`");
            ReadError::new("standard input".as_ref(), refusal)
        };
        let rows = request.draws.ok_or_else(unknown)?;
        let table = request.table(|wanted| TableFile::stream(input, wanted))?;
        match enough(table.rows().unwrap_or(rows), rows) {
            Ok(()) => Ok(Self::of(table, request, rows, 0)),
            Err(refusal) => Err(table.error(refusal)),
        }
    }

    fn of(table: TableFile, request: &Request, rows: u64, left: u64) -> Self {
        let implied = if table.is_single() { SINGLE_TOLERANCE } else { 0.0 };
        let rounding = request.tolerance.unwrap_or(implied);
        let group = request.group.unwrap_or(1);
        Self { table, format: request.rows.clone(), rounding, rows, left, group }
    }

    /// Rows of stage 1.
    #[must_use]
    pub fn first_rows(&self) -> u64 {
        let first = self.rows.div_ceil(3).div_ceil(self.group).saturating_mul(self.group);
        if first < self.rows { first } else { self.rows }
    }

    /// Rows of both stages.
    #[must_use]
    pub fn rows(&self) -> u64 {
        self.rows
    }

    /// Rows of the file that are not judged, because fewer were asked for.
    #[must_use]
    pub(crate) fn left(&self) -> u64 {
        self.left
    }

    /// Bits of the numbers: 24 if they are stored in single precision, else 53.
    #[must_use]
    pub fn resolution_bits(&self) -> u32 {
        if self.table.is_single() { 24 } else { 53 }
    }

    /// The most by which any claim may be off: what single precision implies, else 0.
    #[must_use]
    pub fn tolerance(&self) -> f64 {
        if self.table.is_single() { SINGLE_TOLERANCE } else { 0.0 }
    }

    /// The row that begins `block`. Blocks of stage 2 begin where stage 1 ends, be its last block short.
    fn row(&self, block: u64) -> u64 {
        let (first, blocks) = (self.first_rows(), self.first_rows().div_ceil(BLOCK as u64));
        let row = match block < blocks {
            true => block * BLOCK as u64,
            false => first.saturating_add((block - blocks).saturating_mul(BLOCK as u64)),
        };
        if row < self.rows { row } else { self.rows }
    }

    fn error(&self, refusal: Refusal) -> String {
        self.table.error(refusal).to_string()
    }
}

impl Request {
    /// Begins to read a table of these rows.
    fn table(
        &self,
        begin: impl FnOnce(&TableRequest) -> Result<TableFile, ReadError>,
    ) -> Result<TableFile, ReadError> {
        let select = |head: &Head| self.rows.select(head);
        begin(&TableRequest { format: self.format, across: self.rows.across(), select: &select })
    }

    /// The number of rows judged, of so many.
    fn judged(&self, held: u64) -> Result<u64, Refusal> {
        if held == 0 {
            return Err(Refusal::new("it holds no draw", "at least 1 draw"));
        }
        let rows = self.draws.unwrap_or(held);
        enough(held, rows).map(|()| rows)
    }
}

fn enough(held: u64, rows: u64) -> Result<(), Refusal> {
    match held < rows {
        true => Err(Refusal::new(format!("it holds {held} draws, not {rows}"), "as many as are asked for")),
        false => Ok(()),
    }
}

/// Reads text through to its end: every mistake is found, and the rows are counted.
fn scan(table: &mut dyn Table, format: &RowFormat) -> Result<u64, Refusal> {
    let (mut draws, mut reader) = (Draws::new(&format.row(), BLOCK), RowReader::new(format, 0.0, 0));
    while reader.read(table, BLOCK, &mut draws)? > 0 {}
    Ok(reader.row())
}

impl SampleSource for SampleFile {
    fn open<'a>(&'a self, wanted: &Wanted<'a>) -> Result<Box<dyn Rows + 'a>, String> {
        let (row, end) = (self.row(wanted.blocks.start), self.row(wanted.blocks.end));
        let table = self.table.reader(row).map_err(|refusal| self.error(refusal))?;
        let reader = RowReader::new(&self.format, self.rounding, row);
        Ok(Box::new(FileRows { file: self, table: Some(table), reader, end }))
    }

    fn row(&self) -> Row {
        self.format.row()
    }

    fn finished(&self) -> bool {
        true
    }

    fn is_text(&self) -> bool {
        self.table.is_text()
    }
}

/// The rows of one stage.
struct FileRows<'a> {
    file: &'a SampleFile,
    /// None once it has failed.
    table: Option<Box<dyn Table>>,
    reader: RowReader<'a>,
    end: u64,
}

impl FileRows<'_> {
    fn fill(&mut self, rows: usize, draws: &mut Draws) -> Result<(), Refusal> {
        let Some(table) = &mut self.table else { return Err(Refusal::new("it has failed before", "one reading")) };
        let read = self.reader.read(&mut **table, rows, draws)?;
        if read < rows {
            let (end, all) = (self.reader.row(), self.file.rows);
            return Err(Refusal::new(format!("it ends after {end} of {all} draws"), "as many as it should hold"));
        }
        Ok(())
    }
}

impl Rows for FileRows<'_> {
    fn read(&mut self, draws: &mut Draws) -> Result<usize, String> {
        let left = self.end - self.reader.row();
        let rows = if left < draws.rows() as u64 { left as usize } else { draws.rows() };
        self.fill(rows, draws).map(|()| rows).map_err(|refusal| {
            self.table = None;
            self.file.error(refusal)
        })
    }
}

impl Drop for FileRows<'_> {
    fn drop(&mut self) {
        if let Some(table) = self.table.take() {
            self.file.table.park(self.reader.row(), table);
        }
    }
}

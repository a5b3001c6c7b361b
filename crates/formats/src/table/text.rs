//! Rows of numbers as text.

use super::{Format, Head, Selected, Table};
use crate::error::Refusal;
use crate::open::foreign;
use csv_core::{ReadRecordResult, Reader, ReaderBuilder};
use std::io::{BufRead, BufReader, Read};

/// The longest row, in bytes.
const MOST_BYTES: usize = 65_536;
/// The most columns.
const MOST_COLUMNS: usize = 4096;

/// The rows of `input`.
pub(super) struct Text {
    input: BufReader<Box<dyn Read + Send>>,
    csv: Reader,
    /// Columns are separated by any number of blanks.
    blanks: bool,
    row: Row,
    /// The first row is numbers, and not read yet.
    pending: bool,
    /// Columns of every row.
    across: usize,
    /// The columns that are wanted.
    selected: Vec<Selected>,
}

/// One row: its fields, one after another, and where they end.
struct Row {
    bytes: Vec<u8>,
    ends: Vec<usize>,
    fields: usize,
    /// Its number, from 1.
    line: u64,
}

impl Row {
    fn field(&self, i: usize) -> &[u8] {
        let start = if i == 0 { 0 } else { self.ends[i - 1] };
        self.bytes[start..self.ends[i]].trim_ascii()
    }

    fn fields(&self) -> impl Iterator<Item = &[u8]> {
        (0..self.fields).map(|i| self.field(i))
    }

    /// The head that a first row gives: its names, if no field is a number.
    fn head(&self) -> Head {
        let named = self.fields().all(|field| number(field).is_none());
        let name = |field: &[u8]| String::from_utf8_lossy(field).into_owned();
        let names = if named { self.fields().map(name).collect() } else { Vec::new() };
        Head { names, across: self.fields }
    }

    /// Leaves out fields without a letter.
    fn close_up(&mut self) {
        let (mut kept, mut end, mut start) = (0, 0, 0);
        for i in 0..self.fields {
            let stop = self.ends[i];
            if stop > start {
                self.bytes.copy_within(start..stop, end);
                end += stop - start;
                self.ends[kept] = end;
                kept += 1;
            }
            start = stop;
        }
        self.fields = kept;
    }
}

fn number(field: &[u8]) -> Option<f64> {
    std::str::from_utf8(field).ok()?.parse().ok()
}

/// Tabs become spaces.
struct Spaced(Box<dyn Read + Send>);

impl Read for Spaced {
    fn read(&mut self, bytes: &mut [u8]) -> std::io::Result<usize> {
        let read = self.0.read(bytes)?;
        bytes[..read].iter_mut().filter(|byte| **byte == b'\t').for_each(|byte| *byte = b' ');
        Ok(read)
    }
}

impl Text {
    /// Reads the first row, where names may stand.
    pub(super) fn new(
        input: Box<dyn Read + Send>,
        format: Format,
        select: &dyn Fn(&Head) -> Result<Vec<Selected>, Refusal>,
    ) -> Result<Self, Refusal> {
        let blanks = format == Format::Txt;
        let input: Box<dyn Read + Send> = if blanks { Box::new(Spaced(input)) } else { input };
        let mut csv = ReaderBuilder::new();
        if blanks {
            csv.delimiter(b' ').comment(Some(b'#'));
        }
        let row = Row { bytes: vec![0; MOST_BYTES], ends: vec![0; MOST_COLUMNS], fields: 0, line: 0 };
        let mut input = BufReader::with_capacity(1 << 16, input);
        if let Some(refusal) = foreign(input.fill_buf()?) {
            return Err(refusal);
        }
        let (csv, selected) = (csv.build(), Vec::new());
        let mut text = Self { input, csv, blanks, row, pending: false, across: 0, selected };
        if !text.next()? {
            return Err(Refusal::new("it is empty", "at least 1 row"));
        }
        let head = text.row.head();
        (text.pending, text.across) = (head.names.is_empty(), head.across);
        text.selected = select(&head)?;
        Ok(text)
    }

    pub(super) fn selected(&self) -> &[Selected] {
        &self.selected
    }

    /// Reads the next row that is not empty; false at the end.
    fn next(&mut self) -> Result<bool, Refusal> {
        loop {
            if !self.record()? {
                return Ok(false);
            }
            if self.blanks {
                self.row.close_up();
            }
            if self.row.fields > 0 {
                return Ok(true);
            }
        }
    }

    fn record(&mut self) -> Result<bool, Refusal> {
        let (mut bytes, mut ends) = (0, 0);
        loop {
            let input = self.input.fill_buf()?;
            let Row { bytes: to, ends: stops, .. } = &mut self.row;
            let (result, read, wrote, ended) = self.csv.read_record(input, &mut to[bytes..], &mut stops[ends..]);
            let newline = read > 0 && input[read - 1] == b'\n';
            self.input.consume(read);
            (bytes, ends) = (bytes + wrote, ends + ended);
            let too_large = |what: &str, most| {
                Err(Refusal::new(format!("a row has too many {what}"), format!("at most {most}")))
            };
            match result {
                ReadRecordResult::InputEmpty => {}
                ReadRecordResult::OutputFull => return too_large("bytes", MOST_BYTES),
                ReadRecordResult::OutputEndsFull => return too_large("columns", MOST_COLUMNS),
                ReadRecordResult::End => return Ok(false),
                ReadRecordResult::Record => {
                    self.row.line = self.csv.line() - u64::from(newline); // a carriage return ends a row, too
                    self.row.fields = ends;
                    return Ok(true);
                }
            }
        }
    }

    /// The line at which the row that was read last stands, from 1.
    pub(super) fn line(&self) -> u64 {
        self.row.line
    }

    fn value(&self, Selected { column, words }: Selected) -> Result<f64, Refusal> {
        let field = self.row.field(column);
        let said = || words.iter().find(|word| word.word.as_bytes() == field).map(|word| word.number);
        number(field).or_else(said).ok_or_else(|| {
            let cause = format!("line {}, column {} is not a number", self.row.line, column + 1);
            let separated = if self.blanks { "blanks" } else { "commas" };
            Refusal::new(cause, format!("such as 1.25e-3, inf or nan; columns are separated by {separated}"))
        })
    }
}

impl Table for Text {
    fn read(&mut self, rows: usize, columns: &mut [&mut [f64]]) -> Result<usize, Refusal> {
        for i in 0..rows {
            if !std::mem::take(&mut self.pending) && !self.next()? {
                return Ok(i);
            }
            if self.row.fields != self.across {
                let (line, fields) = (self.row.line, self.row.fields);
                let cause = format!("line {line} has another number of columns, {fields}");
                return Err(Refusal::new(cause, format!("{} as in the first line", self.across)));
            }
            for (column, &selected) in columns.iter_mut().zip(&self.selected) {
                column[i] = self.value(selected)?;
            }
        }
        Ok(rows)
    }
}

//! Draws in a file, or on standard input: read block by block, so that their number does not matter.

use super::{Refusal, SourceError};
use crate::samples::{Rows, SampleKind, SampleSource, Wanted};
use crate::subject::BLOCK;
use freepath_draws::Draws;
use meaning::Meaning;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use table::Table;

mod binary;
pub(super) mod inspect;
pub(crate) mod meaning;
pub(crate) mod table;
#[cfg(test)]
mod tests;
pub(super) mod text;

/// The tolerance that single precision implies: one rounding, relative.
pub const SINGLE_TOLERANCE: f64 = 6e-8;

/// How a file of samples is written.
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

/// Which free paths are escapes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Escape {
    /// Those at infinity.
    #[default]
    Infinity,
    /// Those at the length of the ray or beyond, but for rounding.
    AtLength,
}

/// What the rows of a file of samples are.
#[derive(Clone, Debug)]
pub struct Request<'a> {
    /// What they say.
    pub kind: SampleKind,
    /// How they are written; none if the ending of the file's name tells.
    pub format: Option<Format>,
    /// The column of the draws, by name or by number from 0; none if there is only one.
    pub column: Option<&'a str>,
    /// The column of weights.
    pub weight: Option<&'a str>,
    /// What an escape is.
    pub escape: Escape,
    /// Channels of a chromatic draw.
    pub channels: usize,
    /// Length of the ray.
    pub length: f64,
    /// How many rows to judge, from the first one on; none for all, which standard input cannot.
    pub draws: Option<u64>,
    /// The relative error of a distance; none for what the type of the numbers implies.
    pub tolerance: Option<f64>,
}

/// A file of samples: the first third of its rows, in drawing order, is stage 1, and the rest stage 2.
pub struct SampleFile {
    /// None for standard input.
    path: Option<PathBuf>,
    layout: inspect::Layout,
    meaning: Meaning,
    /// Rows that are judged.
    rows: u64,
    /// Rows that are not.
    left: u64,
    /// Where a reader stands, so that text is not read twice, and standard input, which cannot be, can be read on.
    parked: Mutex<Option<(u64, Box<dyn Table>)>>,
}

impl SampleFile {
    /// The samples in `path`, or on standard input if that is `-`. Text is read through once, so that every mistake in it
    /// is found before any draw is judged.
    ///
    /// # Errors
    /// If the file is not regular, empty, not what its format or `request` says, cut short, or holds text where a number
    /// should be.
    pub fn open(path: &Path, request: &Request) -> Result<Self, SourceError> {
        if path == Path::new("-") {
            return Self::stream(Box::new(std::io::stdin()), request);
        }
        inspect::open(path, request).map_err(|refusal| SourceError { file: path.to_path_buf(), refusal })
    }

    /// The samples that `input` gives, once: raw doubles unless `request` states a format, and as many as it asks for.
    ///
    /// # Errors
    /// If the input does not begin as its format or `request` says, or the number of draws is not known.
    pub fn stream(input: Box<dyn Read + Send>, request: &Request) -> Result<Self, SourceError> {
        inspect::stream(input, request).map_err(|refusal| SourceError { file: shown(None), refusal })
    }

    /// Rows of stage 1.
    #[must_use]
    pub fn first_rows(&self) -> u64 {
        self.rows.div_ceil(3)
    }

    /// Rows of both stages.
    #[must_use]
    pub fn rows(&self) -> u64 {
        self.rows
    }

    /// Rows of the file that are not judged, because fewer were asked for.
    #[must_use]
    pub fn left(&self) -> u64 {
        self.left
    }

    /// Bits of the numbers: 24 if they are stored in single precision, else 53.
    #[must_use]
    pub fn resolution_bits(&self) -> u32 {
        if self.layout.single() { 24 } else { 53 }
    }

    /// How far every claim may be off: what single precision implies, else 0.
    #[must_use]
    pub fn tolerance(&self) -> f64 {
        if self.layout.single() { SINGLE_TOLERANCE } else { 0.0 }
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

    /// A reader that stands at `row`.
    fn reader(&self, row: u64) -> Result<Box<dyn Table>, Refusal> {
        let parked = self.parked.lock().unwrap_or_else(PoisonError::into_inner).take();
        match (parked, &self.path) {
            (Some((at, table)), _) if at == row => Ok(table),
            (_, None) => Err(Refusal::new("it cannot be read twice", "save it in a file")),
            (_, Some(path)) => self.layout.reopen(path, row),
        }
    }

    fn error(&self, refusal: Refusal) -> String {
        SourceError { file: shown(self.path.as_deref()), refusal }.to_string()
    }
}

fn shown(path: Option<&Path>) -> PathBuf {
    path.unwrap_or(Path::new("standard input")).to_path_buf()
}

impl SampleSource for SampleFile {
    fn open<'a>(&'a self, wanted: &Wanted<'a>) -> Result<Box<dyn Rows + 'a>, String> {
        let (at, end) = (self.row(wanted.blocks.start), self.row(wanted.blocks.end));
        let table = self.reader(at).map_err(|refusal| self.error(refusal))?;
        Ok(Box::new(FileRows { file: self, table: Some(table), at, end, events: Vec::new() }))
    }

    fn finished(&self) -> bool {
        true
    }
}

/// The rows of one stage.
struct FileRows<'a> {
    file: &'a SampleFile,
    /// None once it has failed.
    table: Option<Box<dyn Table>>,
    at: u64,
    end: u64,
    events: Vec<f64>,
}

impl FileRows<'_> {
    fn fill(&mut self, rows: usize, draws: &mut Draws) -> Result<(), Refusal> {
        let Some(table) = &mut self.table else { return Err(Refusal::new("it has failed before", "one reading")) };
        let read = self.file.meaning.read(&mut **table, rows, draws, &mut self.events, self.at)?;
        if read < rows {
            let (end, all) = (self.at + read as u64, self.file.rows);
            return Err(Refusal::new(format!("it ends after {end} of {all} draws"), "as many as it should hold"));
        }
        Ok(())
    }
}

impl Rows for FileRows<'_> {
    fn read(&mut self, draws: &mut Draws) -> Result<usize, String> {
        let left = self.end - self.at;
        let rows = if left < draws.rows() as u64 { left as usize } else { draws.rows() };
        match self.fill(rows, draws) {
            Ok(()) => {
                self.at += rows as u64;
                Ok(rows)
            }
            Err(refusal) => {
                self.table = None;
                Err(self.file.error(refusal))
            }
        }
    }
}

impl Drop for FileRows<'_> {
    fn drop(&mut self) {
        let parked = self.table.take().map(|table| (self.at, table));
        *self.file.parked.lock().unwrap_or_else(PoisonError::into_inner) = parked;
    }
}

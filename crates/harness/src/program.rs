//! Programs as subjects: started for each stage, told by one line of JSON what to draw, and read from standard output.
//!
//! A program runs in a process group of its own, in the folder of its case. It reads one line,
//!
//! ```text
//! {"protocol":1,"kind":"free_path","medium":{..},"majorants":[{"end":..,"mu_bar":..}],"length":..,"draws":N,"seed":S,
//!  "stage":1,"case_file":"..","table":"..","rows_per_cell":2,"table_error":0.0}
//! ```
//!
//! and writes exactly N rows of doubles, little endian: a free path is t, infinity for an escape (t that is the length within
//! the tolerance counts as one); a transmittance is an estimate; a chromatic row is t, event (0 scatters, 1 is the surface) and
//! a weight per channel. S is below 2^53, and another for each stage. The table is mu(t) under the majorants, as polynomials through
//! the rows of each cell; in a chromatic medium `sigma_t` and `sigma_s` of each channel stand in its place.
//!
//! Before stage 1 four short starts show whether one seed gives the same bytes twice (else `not_reproducible`), and two seeds
//! give different ones, be it that their highest bits alone differ (else `dependent`). A program that passes stage 1 is started once more
//! for 65,536 rows, none of which may be rows of stage 1.

use crate::samples::{RowFormat, RowReader, Rows, SampleSource, Wanted};
use crate::subject::BLOCK;
use freepath_draws::{Draws, Row};
use freepath_formats::{Refusal, Table};
use freepath_statistics::Fact;
use log::Log;
use nodes::NodeTable;
use process::Process;
use std::path::PathBuf;
use std::time::Duration;

mod limits;
mod log;
mod nodes;
#[cfg(unix)]
mod process;
#[cfg(not(unix))]
#[path = "program/unsupported.rs"]
mod process;
mod rehearsal;
mod request;

pub(crate) use limits::IDLE;
pub use limits::IDLE_RANGE;
pub(crate) use request::Setting;

/// A program that is started for each stage.
pub struct Program {
    /// The program and its arguments; not empty.
    argv: Vec<String>,
    /// The folder that it runs in.
    folder: PathBuf,
    idle: Duration,
    format: RowFormat,
    /// The relative error of a distance.
    tolerance: f64,
    request: serde_json::Map<String, serde_json::Value>,
    log: Log,
    /// The medium; the file lives as long as the program.
    _table: Option<NodeTable>,
}

impl Program {
    /// `argv`, to be run in `folder` and to be killed after the silence `idle`.
    ///
    /// # Errors
    /// If there is no table of the medium.
    pub(crate) fn new(
        argv: &[String],
        folder: PathBuf,
        idle: Duration,
        setting: &Setting,
    ) -> Result<Self, Refusal> {
        let table = setting.truth.map(NodeTable::write).transpose()?;
        let request = setting.request(table.as_ref());
        let Setting { rows, tolerance, .. } = setting;
        let (argv, format, log) = (argv.to_vec(), rows.clone(), Log::default());
        Ok(Self { argv, folder, idle, format, tolerance: *tolerance, request, log, _table: table })
    }

    /// Its output on standard error so far, in all its starts, up to 64 KiB.
    #[must_use]
    pub(crate) fn log(&self) -> String {
        self.log.text()
    }

    fn start<'a>(
        &'a self,
        draws: u64,
        seed: u64,
        stage: u32,
        wanted: &Wanted<'a>,
    ) -> Result<Process<'a>, Refusal> {
        let line = request::line(&self.request, draws, seed, stage);
        let started = process::Start {
            argv: &self.argv,
            folder: &self.folder,
            idle: self.idle,
            log: &self.log,
            cancelled: wanted.cancelled,
        };
        started.start(line, draws.saturating_mul(8 * self.across() as u64))
    }

    /// Numbers of a row.
    fn across(&self) -> usize {
        self.format.columns.len()
    }

    fn error(&self, refusal: &Refusal) -> String {
        format!("cannot run {}: {refusal}", self.argv[0])
    }
}

impl SampleSource for Program {
    fn open<'a>(&'a self, wanted: &Wanted<'a>) -> Result<Box<dyn Rows + 'a>, String> {
        let draws = (wanted.blocks.end - wanted.blocks.start).saturating_mul(BLOCK as u64);
        let (seed, stage) =
            (request::seed(wanted, wanted.blocks.start), crate::blocks::stage_of(wanted.blocks.start));
        let process = self.start(draws, seed, stage, wanted).map_err(|why| self.error(&why))?;
        let output = Output { process, across: self.across(), bytes: Vec::new() };
        let reader = RowReader::new(&self.format, self.tolerance, 0);
        Ok(Box::new(ProgramRows { program: self, output, reader, left: draws }))
    }

    fn row(&self) -> Row {
        self.format.row()
    }

    fn finished(&self) -> bool {
        false
    }

    fn rehearse(&self, wanted: &Wanted) -> Result<Vec<Fact>, String> {
        self.short_starts(wanted).map_err(|why| self.error(&why))
    }
}

/// The numbers that a process writes.
struct Output<'a> {
    process: Process<'a>,
    across: usize,
    bytes: Vec<u8>,
}

impl Table for Output<'_> {
    fn read(&mut self, rows: usize, columns: &mut [&mut [f64]]) -> Result<usize, Refusal> {
        self.bytes.resize(rows * self.across * 8, 0);
        self.process.fill(&mut self.bytes)?;
        let (cells, _) = self.bytes.as_chunks::<8>();
        for (i, column) in columns.iter_mut().enumerate() {
            let of_column = cells.iter().skip(i).step_by(self.across);
            column.iter_mut().zip(of_column).for_each(|(x, cell)| *x = f64::from_le_bytes(*cell));
        }
        Ok(rows)
    }
}

/// The rows of one stage.
struct ProgramRows<'a> {
    program: &'a Program,
    output: Output<'a>,
    reader: RowReader<'a>,
    left: u64,
}

impl ProgramRows<'_> {
    fn fill(&mut self, rows: usize, draws: &mut Draws) -> Result<(), Refusal> {
        self.reader.read(&mut self.output, rows, draws)?;
        self.left -= rows as u64;
        if self.left == 0 { self.output.process.finish() } else { Ok(()) }
    }
}

impl Rows for ProgramRows<'_> {
    fn read(&mut self, draws: &mut Draws) -> Result<usize, String> {
        let rows = if self.left < draws.rows() as u64 { self.left as usize } else { draws.rows() };
        if rows > 0 {
            self.fill(rows, draws).map_err(|why| self.program.error(&why))?;
        }
        Ok(rows)
    }
}

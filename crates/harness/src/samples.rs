//! Draws that are made elsewhere: a finished file, a pipe, or a program that is started for each stage.

mod escapes;
mod events;
mod file;
mod row_format;
mod row_reader;

use freepath_draws::{Draws, Row};
use freepath_statistics::Fact;
use std::ops::Range;
use std::sync::atomic::AtomicBool;

pub(crate) use escapes::mark_escapes;
pub use escapes::{Escape, EscapeRule, Escapes};
pub use file::{Request, SampleFile};
pub use row_format::{ColumnFormat, Excess, Fills, Place, Reading, RowFormat};
pub(crate) use row_reader::RowReader;

/// The rows that a stage asks for.
#[derive(Clone, Debug)]
pub struct Wanted<'a> {
    /// The seed of the run.
    pub seed: u64,
    /// The subject's part of every key.
    pub subject: u64,
    /// The blocks: those of stage 1 begin with 0, and no two stages share one.
    pub blocks: Range<u64>,
    /// Set to cancel.
    pub cancelled: &'a AtomicBool,
}

/// A source of draws that no subject of this process makes. Nothing is known of their look-ups.
pub trait SampleSource: Send + Sync {
    /// The rows of `wanted.blocks` from the first on.
    ///
    /// # Errors
    /// Why there are none, in words that repeat nothing of a file's content: the subject fails as `subject_error`.
    fn open<'a>(&'a self, wanted: &Wanted<'a>) -> Result<Box<dyn Rows + 'a>, String>;

    /// The columns of its rows.
    fn row(&self) -> Row;

    /// True if every draw is made already: then both stages are read, whatever the first one gives, so that all draws
    /// are judged.
    fn finished(&self) -> bool;

    /// True if its numbers are written as text. Provided: they are not.
    fn is_text(&self) -> bool {
        false
    }

    /// Facts from a few draws before any stage, without statistics. Provided: none.
    ///
    /// # Errors
    /// Why there are none, in words.
    fn rehearse(&self, _wanted: &Wanted) -> Result<Vec<Fact>, String> {
        Ok(Vec::new())
    }
}

/// The rows of one stage, in drawing order.
pub trait Rows: Send {
    /// Writes the next block into the first rows of the wanted columns of `draws`, and says how many there are: fewer than
    /// `draws.rows()` at the end of the stage, 0 after it.
    ///
    /// # Errors
    /// Why the rows end too early or cannot be used, in words.
    fn read(&mut self, draws: &mut Draws) -> Result<usize, String>;
}

//! From the numbers of a table to draws.

use super::escapes::mark_escapes;
use super::events::decode_events;
use super::row_format::{Fills, Reading, RowFormat};
use freepath_draws::{Draws, MissingColumn, NumbersMut, column};
use freepath_formats::{Refusal, Table};

/// Reads rows of one format, one after another.
#[derive(Clone, Debug)]
pub(crate) struct RowReader<'a> {
    format: &'a RowFormat,
    /// The relative error of a distance.
    tolerance: f64,
    /// The number of the next row, from 0.
    row: u64,
    events: Vec<f64>,
}

impl<'a> RowReader<'a> {
    /// A reader that stands at `row`; distances have the relative error `tolerance`.
    pub(crate) fn new(format: &'a RowFormat, tolerance: f64, row: u64) -> Self {
        Self { format, tolerance, row, events: Vec::new() }
    }

    /// The number of the next row, from 0.
    pub(crate) fn row(&self) -> u64 {
        self.row
    }

    /// Reads the next rows of `table`, at most `rows`, into the columns of `draws`, and says how many there were.
    ///
    /// # Errors
    /// If the table cannot be read, holds an event that is not known, or `draws` lacks a column.
    pub(crate) fn read(
        &mut self,
        table: &mut dyn Table,
        rows: usize,
        draws: &mut Draws,
    ) -> Result<usize, Refusal> {
        let has_events = self.format.columns.iter().any(|column| column.fills == Fills::Event);
        self.events.resize(if has_events { rows } else { 0 }, f64::NAN);
        let read = table.read(rows, &mut self.filled(draws)?)?;
        for column in &self.format.columns {
            match column.reading {
                Reading::Plain => {}
                Reading::FreePath(rule) => mark_escapes(&mut paths(draws)?[..read], rule, self.tolerance),
                Reading::Event => decode_events(&mut paths(draws)?[..read], &self.events[..read], self.row)?,
            }
        }
        self.row += read as u64;
        Ok(read)
    }

    /// The destinations of the numbers of each column.
    fn filled<'d>(&'d mut self, draws: &'d mut Draws) -> Result<Vec<&'d mut [f64]>, Refusal> {
        let mut open: Vec<Option<(&str, &mut [f64])>> = Vec::new();
        open.extend(draws.columns_mut().map(|(column, numbers)| match numbers {
            NumbersMut::F64(numbers) => Some((column.name(), numbers)),
            NumbersMut::U32(_) => None,
        }));
        let mut events = Some(&mut self.events[..]);
        let mut place = |fills: &Fills| match fills {
            Fills::Column(name) => {
                let found = open.iter_mut().find(|column| column.as_ref().is_some_and(|column| column.0 == name));
                found.and_then(Option::take).map(|(_, numbers)| numbers)
            }
            Fills::Event => events.take(),
        };
        let mut filled = Vec::new();
        for column in &self.format.columns {
            let cause = || format!("nothing takes its column {:?}", column.name);
            filled.push(place(&column.fills).ok_or_else(|| Refusal::new(cause(), "a column of draws"))?);
        }
        Ok(filled)
    }
}

/// The column of free paths.
fn paths(draws: &mut Draws) -> Result<&mut [f64], Refusal> {
    draws.f64_mut(column::T).map_err(|missing: MissingColumn| Refusal::new(missing.to_string(), "a free path"))
}

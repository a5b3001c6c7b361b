//! From the numbers of a table to draws.

use super::escapes::mark_escapes;
use super::events::decode_events;
use super::row_format::{Column, ColumnFormat, Reading, RowFormat};
use freepath_draws::Draws;
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
        let told = self.format.columns.iter().any(|column| column.fills == Column::Event);
        self.events.resize(if told { rows } else { 0 }, f64::NAN);
        let read = table.read(rows, &mut self.filled(draws)?)?;
        for column in &self.format.columns {
            match column.reading {
                Reading::Plain => {}
                Reading::FreePath(rule) => mark_escapes(&mut draws.t[..read], rule, self.tolerance),
                Reading::Event => decode_events(&mut draws.t[..read], &self.events[..read], self.row)?,
            }
        }
        self.row += read as u64;
        Ok(read)
    }

    /// Where the numbers of each column go.
    fn filled<'d>(&'d mut self, draws: &'d mut Draws) -> Result<Vec<&'d mut [f64]>, Refusal> {
        let Draws { t, weight, channels, .. } = draws;
        let (mut t, mut weight, mut events) = (Some(t), Some(weight), Some(&mut self.events));
        let mut channels: Vec<_> = channels.iter_mut().map(Some).collect();
        let place = |column: &ColumnFormat| {
            let taken = match column.fills {
                Column::T => t.take(),
                Column::Weight => weight.take(),
                Column::Channel(k) => channels.get_mut(k).and_then(Option::take),
                Column::Event => events.take(),
            };
            let missing =
                || Refusal::new(format!("nothing takes its column {:?}", column.name), "a column of draws");
            taken.map(Vec::as_mut_slice).ok_or_else(missing)
        };
        self.format.columns.iter().map(place).collect()
    }
}

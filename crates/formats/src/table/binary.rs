//! Rows of numbers of one width: `.npy` after its header, and raw doubles.

use super::{Selected, Table};
use crate::encoding::{Encoding, NumberType};
use crate::error::Refusal;
use std::io::{ErrorKind, Read};

/// Bytes read at a time: more than any row has, and no more for a block of wide rows.
const PART: usize = 1 << 20;

/// The storage of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Cell {
    /// Four bytes instead of eight.
    pub(super) single: bool,
    pub(super) big_endian: bool,
}

impl Cell {
    /// None of whole numbers.
    pub(super) fn of(encoding: Encoding) -> Option<Self> {
        let cell = |single| Some(Self { single, big_endian: encoding.big_endian });
        match encoding.number {
            NumberType::U8 | NumberType::U16 => None,
            NumberType::F32 => cell(true),
            NumberType::F64 => cell(false),
        }
    }

    pub(super) fn width(self) -> usize {
        if self.single { 4 } else { 8 }
    }
}

/// The rows of `input`.
pub(super) struct Binary {
    pub(super) input: Box<dyn Read + Send>,
    pub(super) cell: Cell,
    /// Numbers in a row.
    pub(super) across: usize,
    /// The columns that are wanted.
    pub(super) selected: Vec<Selected>,
    /// Bytes of one call of `read`.
    pub(super) bytes: Vec<u8>,
}

impl Binary {
    /// Reads until `bytes` is full or the input ends, and says how much there was.
    fn fill(&mut self) -> Result<usize, Refusal> {
        let mut filled = 0;
        while filled < self.bytes.len() {
            match self.input.read(&mut self.bytes[filled..]) {
                Ok(0) => break,
                Ok(more) => filled += more,
                Err(why) if why.kind() == ErrorKind::Interrupted => {}
                Err(why) => return Err(why.into()),
            }
        }
        Ok(filled)
    }

    fn decode(&self, wanted: usize, column: &mut [f64]) {
        let Cell { single, big_endian } = self.cell;
        let place = (wanted, self.across);
        match (single, big_endian) {
            (false, false) => decode(&self.bytes, place, column, f64::from_le_bytes),
            (false, true) => decode(&self.bytes, place, column, f64::from_be_bytes),
            (true, false) => decode(&self.bytes, place, column, |x| f64::from(f32::from_le_bytes(x))),
            (true, true) => decode(&self.bytes, place, column, |x| f64::from(f32::from_be_bytes(x))),
        }
    }
}

/// Every `across`-th number, from number `wanted` on.
fn decode<const W: usize>(
    bytes: &[u8],
    (wanted, across): (usize, usize),
    column: &mut [f64],
    number: impl Fn([u8; W]) -> f64,
) {
    let (cells, _) = bytes.as_chunks::<W>();
    if across == 1 {
        column.iter_mut().zip(cells).for_each(|(x, cell)| *x = number(*cell)); // a loop that vectorises
    } else {
        let cells = cells.iter().skip(wanted).step_by(across);
        column.iter_mut().zip(cells).for_each(|(x, cell)| *x = number(*cell));
    }
}

impl Binary {
    /// The next rows, at most `rows`, written from place `at` of each column on.
    fn part(&mut self, rows: usize, at: usize, columns: &mut [&mut [f64]]) -> Result<usize, Refusal> {
        let row = self.across * self.cell.width();
        self.bytes.resize(rows * row, 0);
        let filled = self.fill()?;
        if !filled.is_multiple_of(row) {
            return Err(Refusal::new("it ends within a row", format!("rows of {row} bytes")));
        }
        let rows = filled / row;
        for (selected, column) in self.selected.iter().zip(columns) {
            self.decode(selected.column, &mut column[at..at + rows]);
        }
        Ok(rows)
    }
}

impl Table for Binary {
    fn read(&mut self, rows: usize, columns: &mut [&mut [f64]]) -> Result<usize, Refusal> {
        let (most, mut done) = (PART / (self.across * self.cell.width()), 0);
        while done < rows {
            let part = if rows - done < most { rows - done } else { most };
            let read = self.part(part, done, columns)?;
            done += read;
            if read < part {
                break;
            }
        }
        Ok(done)
    }
}

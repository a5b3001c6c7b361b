//! One block of draws on its way through the folds.

use crate::tally::Audit;
use freepath_draws::{Draws, MissingColumn};

/// A block of draws, where it stands, and what it cost.
#[derive(Clone, Copy)]
pub struct Block<'a> {
    /// Its rows.
    pub draws: &'a Draws,
    /// Its number among all blocks of its subject.
    pub number: u64,
    /// Its place in the range that is being collected.
    pub nth: u64,
    /// Its look-ups; none of draws that are made elsewhere.
    pub audit: Option<&'a Audit>,
}

/// Blocks at the start of a range in which all ties are counted and all look-ups placed.
const FIRST_BLOCKS: u64 = 4;

impl Block<'_> {
    /// True if it is among the first of its range.
    #[must_use]
    pub fn is_early(&self) -> bool {
        is_early(self.nth)
    }

    /// The place of its first row in the range: all blocks but the last have as many rows.
    pub(crate) fn first_row(&self) -> u64 {
        self.nth * self.draws.rows() as u64
    }
}

/// True if the block at this place of a range is among the first.
#[must_use]
pub(crate) fn is_early(nth: u64) -> bool {
    nth < FIRST_BLOCKS
}

/// Buffers of a worker, used again for each block.
#[derive(Debug, Default)]
pub struct Scratch {
    indices: Vec<Vec<u32>>,
    /// A column with some rows set to 0.
    pub(crate) masked: Vec<f64>,
    /// The scores of a column.
    pub(crate) scores: Vec<i16>,
}

/// The place in [`Scratch`] of the fine cells of one column under one law: found once per block, read by many folds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CellIndex(pub(crate) usize);

impl Scratch {
    /// The cells of the rows of this block; empty before they are found.
    #[must_use]
    pub fn cells(&self, index: CellIndex) -> &[u32] {
        self.indices.get(index.0).map_or(&[], Vec::as_slice)
    }

    pub(crate) fn cells_mut(&mut self, index: CellIndex) -> &mut Vec<u32> {
        if self.indices.len() <= index.0 {
            self.indices.resize_with(index.0 + 1, Vec::new);
        }
        &mut self.indices[index.0]
    }
}

impl<'a> Block<'a> {
    /// A column of numbers.
    ///
    /// # Errors
    /// If there is none of this name.
    pub(crate) fn f64(&self, column: &str) -> Result<&'a [f64], MissingColumn> {
        self.draws.f64(column)
    }

    /// A column of counts.
    ///
    /// # Errors
    /// If there is none of this name.
    pub(crate) fn u32(&self, column: &str) -> Result<&'a [u32], MissingColumn> {
        self.draws.u32(column)
    }

    /// Hands `each` the numbers of some columns, row by row.
    ///
    /// # Errors
    /// If one of the columns is not there.
    pub(crate) fn for_each_row(
        &self,
        columns: &[&str],
        mut each: impl FnMut(&[f64]),
    ) -> Result<(), MissingColumn> {
        let columns: Vec<&[f64]> = columns.iter().map(|name| self.f64(name)).collect::<Result<_, _>>()?;
        let mut row = vec![0.0; columns.len()];
        for i in 0..self.draws.rows() {
            row.iter_mut().zip(&columns).for_each(|(number, column)| *number = column[i]);
            each(&row);
        }
        Ok(())
    }
}

//! A small table, read whole.

use super::text::Text;
use super::{Format, Head, Selected, Table};
use crate::array::Array;
use crate::error::{ReadError, Refusal};
use crate::npy::{Header, NUMBERS};
use crate::open::Regular;
use std::fs::File;
use std::io::{Seek, SeekFrom};
use std::path::Path;

/// A visitor of the rows of `N` columns.
struct Rows<'a, const N: usize> {
    most: usize,
    select: &'a dyn Fn(&Head) -> Result<[usize; N], Refusal>,
    accept: &'a mut dyn FnMut([f64; N]) -> Result<(), Refusal>,
}

/// Hands every row of the columns that `select` finds to `accept`, in the file `path`: `.csv` or `.txt` with or without names
/// in the first line, or `.npy` (u8, u16, f32 or f64, little or big endian, C or Fortran order).
///
/// # Errors
/// If the file is not regular, not such a table, cut short, empty, above `most` rows, or has no such column; or if a row is not
/// accepted, in the words of `accept` and with the row's place. Nothing is allocated for rows that the file does not hold.
pub fn read_rows<const N: usize>(
    path: &Path,
    most: usize,
    select: &dyn Fn(&Head) -> Result<[usize; N], Refusal>,
    accept: &mut dyn FnMut([f64; N]) -> Result<(), Refusal>,
) -> Result<(), ReadError> {
    Rows { most, select, accept }.read(path).map_err(|refusal| ReadError::new(path, refusal))
}

impl<const N: usize> Rows<'_, N> {
    fn read(self, path: &Path) -> Result<(), Refusal> {
        let Regular { file, size } = Regular::open(path)?;
        let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
        match ending.to_str() {
            Some("csv") => self.text(file, Format::Csv),
            Some("txt") => self.text(file, Format::Txt),
            Some("npy") => self.npy(file, size),
            _ => Err(Refusal::new("its name does not tell its format", ".csv, .txt or .npy")),
        }
    }

    fn text(self, file: File, format: Format) -> Result<(), Refusal> {
        let select = |head: &Head| Ok((self.select)(head)?.map(Selected::numbers).to_vec());
        let mut text = Text::new(Box::new(file), format, &select)?;
        let (mut row, mut rows) = ([[0.0]; N], 0);
        while text.read(1, &mut row.each_mut().map(|cell| cell.as_mut_slice()))? == 1 {
            if rows == self.most {
                return Err(self.too_many());
            }
            (self.accept)(row.map(|[x]| x)).map_err(|why| why.at(&format!("line {}", text.line())))?;
            rows += 1;
        }
        match rows {
            0 => Err(Refusal::new("it has names but no row of numbers", "at least 1 row")),
            _ => Ok(()),
        }
    }

    fn npy(self, mut file: File, size: u64) -> Result<(), Refusal> {
        let Header { encoding, fortran, shape, start } = Header::read(&mut file, NUMBERS)?;
        let [rows, across] = shape[..] else {
            let cause = format!("its array has {} dimensions", shape.len());
            return Err(Refusal::new(cause, "a table has 2, [row][column]"));
        };
        if rows == 0 {
            return Err(Refusal::new("it has no row", "at least 1 row"));
        }
        if rows > self.most as u64 {
            return Err(self.too_many());
        }
        let selected = (self.select)(&Head::unnamed(usize::try_from(across).unwrap_or(usize::MAX)))?;
        let array = Array { encoding, fortran, shape: [rows, 1, 1], channels: across, start };
        let shape = array.checked(size)?;
        let mut all = vec![[0.0; N]; shape[0]];
        for (k, column) in selected.into_iter().enumerate() {
            file.seek(SeekFrom::Start(start))?;
            let values = array.values(&mut file, shape, column)?;
            all.iter_mut().zip(values).for_each(|(row, value)| row[k] = value);
        }
        for (i, row) in all.into_iter().enumerate() {
            (self.accept)(row).map_err(|why| why.at(&format!("row {}", i + 1)))?;
        }
        Ok(())
    }

    fn too_many(&self) -> Refusal {
        Refusal::new("it has too many rows", format!("at most {}", self.most))
    }
}

use crate::column::ColumnKind;

/// The numbers of one column.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Stored {
    F64(Vec<f64>),
    U32(Vec<u32>),
}

/// The numbers of one column, to be read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Numbers<'a> {
    /// Of type [`ColumnKind::F64`].
    F64(&'a [f64]),
    /// Of type [`ColumnKind::U32`].
    U32(&'a [u32]),
}

/// The numbers of one column, to be written.
#[derive(Debug, PartialEq)]
pub enum NumbersMut<'a> {
    /// Of type [`ColumnKind::F64`].
    F64(&'a mut [f64]),
    /// Of type [`ColumnKind::U32`].
    U32(&'a mut [u32]),
}

impl Stored {
    /// Numbers that nobody wrote.
    pub(super) fn blank(kind: ColumnKind, rows: usize) -> Self {
        match kind {
            ColumnKind::F64 => Self::F64(vec![f64::NAN; rows]),
            ColumnKind::U32 => Self::U32(vec![0; rows]),
        }
    }

    pub(super) fn fill_blank(&mut self) {
        match self {
            Self::F64(numbers) => numbers.fill(f64::NAN),
            Self::U32(counts) => counts.fill(0),
        }
    }

    /// Rows that are new are blank.
    pub(super) fn resize(&mut self, rows: usize) {
        match self {
            Self::F64(numbers) => numbers.resize(rows, f64::NAN),
            Self::U32(counts) => counts.resize(rows, 0),
        }
    }

    pub(super) fn view(&self) -> Numbers<'_> {
        match self {
            Self::F64(numbers) => Numbers::F64(numbers),
            Self::U32(counts) => Numbers::U32(counts),
        }
    }

    pub(super) fn view_mut(&mut self) -> NumbersMut<'_> {
        match self {
            Self::F64(numbers) => NumbersMut::F64(numbers),
            Self::U32(counts) => NumbersMut::U32(counts),
        }
    }
}

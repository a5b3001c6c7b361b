use crate::column::{self, Column, ColumnKind};
use crate::draws::{Draws, MissingColumn, NumbersMut};

/// The columns that a chromatic draw writes, found once for a block.
#[derive(Debug)]
pub struct ChannelColumns<'a> {
    /// The distances.
    pub t: &'a mut [f64],
    /// The weights of each channel.
    pub channels: Vec<&'a mut [f64]>,
}

impl<'a> ChannelColumns<'a> {
    /// The columns of `draws`.
    ///
    /// # Errors
    /// If there are no distances, or no weights of channel 0.
    pub fn of(draws: &'a mut Draws) -> Result<Self, MissingColumn> {
        let row = draws.row().clone();
        let (mut t, mut channels) = (None, Vec::new());
        for (column, numbers) in draws.columns_mut() {
            match numbers {
                NumbersMut::F64(numbers) if column.name() == column::T => t = Some(numbers),
                NumbersMut::F64(numbers) if column.name() == column::channel(channels.len()) => {
                    channels.push(numbers)
                }
                NumbersMut::F64(_) | NumbersMut::U32(_) => {}
            }
        }
        let missing = |name| MissingColumn::new(Column::new(name, ColumnKind::F64), row.clone());
        if channels.is_empty() {
            return Err(missing(column::channel(0)));
        }
        Ok(Self { t: t.ok_or_else(|| missing(column::T.into()))?, channels })
    }

    /// Writes one row: a distance, and the weight of each channel.
    #[inline(always)]
    pub fn put(&mut self, row: usize, t: f64, weights: &[f64]) {
        self.t[row] = t;
        for (column, weight) in self.channels.iter_mut().zip(weights) {
            column[row] = *weight;
        }
    }
}

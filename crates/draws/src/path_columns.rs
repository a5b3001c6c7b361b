use crate::column;
use crate::draws::{Draws, NumbersMut};

/// The columns that a walk writes, found once for a block: [`T`](column::T), [`WEIGHT`](column::WEIGHT),
/// [`COLLISIONS`](column::COLLISIONS) and [`AUXILIARY`](column::AUXILIARY). One that the block does not have is not wanted: what
/// is written to it is dropped, at no cost.
///
/// ```
/// use freepath_draws::{Draws, PathColumns, Row, column};
///
/// let mut draws = Draws::new(&Row::new().with_f64(column::T), 2);
/// let mut columns = PathColumns::of(&mut draws);
/// for row in 0..columns.rows() {
///     columns.put(row, 0.5 * row as f64, 1.0, 0);
/// }
/// assert_eq!(draws.f64(column::T)?, [0.0, 0.5]);
/// # Ok::<(), freepath_draws::MissingColumn>(())
/// ```
#[derive(Debug, Default)]
pub struct PathColumns<'a> {
    rows: usize,
    // Empty where it is not wanted: then the check of the bound, which is made in any case, is all that a row costs.
    t: &'a mut [f64],
    weight: &'a mut [f64],
    collisions: &'a mut [u32],
    auxiliary: &'a mut [f64],
}

impl<'a> PathColumns<'a> {
    /// The columns of `draws`.
    #[must_use]
    pub fn of(draws: &'a mut Draws) -> Self {
        let mut found = Self { rows: draws.rows(), ..Self::default() };
        for (column, numbers) in draws.columns_mut() {
            found.keep(column.name(), numbers);
        }
        found
    }

    /// Keeps `numbers` if a walk writes a column of this name and type.
    fn keep(&mut self, name: &str, numbers: NumbersMut<'a>) {
        match (name, numbers) {
            (column::T, NumbersMut::F64(t)) => self.t = t,
            (column::WEIGHT, NumbersMut::F64(weight)) => self.weight = weight,
            (column::COLLISIONS, NumbersMut::U32(collisions)) => self.collisions = collisions,
            (column::AUXILIARY, NumbersMut::F64(auxiliary)) => self.auxiliary = auxiliary,
            (_, NumbersMut::F64(_) | NumbersMut::U32(_)) => {}
        }
    }

    /// The number of rows.
    #[inline(always)]
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// True if the block has a column of auxiliary numbers.
    #[must_use]
    pub fn wants_auxiliary(&self) -> bool {
        !self.auxiliary.is_empty()
    }

    /// Writes one row, but for its auxiliary number.
    #[inline(always)]
    pub fn put(&mut self, row: usize, t: f64, weight: f64, collisions: u32) {
        if let Some(x) = self.t.get_mut(row) {
            *x = t;
        }
        if let Some(x) = self.weight.get_mut(row) {
            *x = weight;
        }
        if let Some(x) = self.collisions.get_mut(row) {
            *x = collisions;
        }
    }

    /// Writes the auxiliary number of one row.
    #[inline(always)]
    pub fn put_auxiliary(&mut self, row: usize, auxiliary: f64) {
        if let Some(x) = self.auxiliary.get_mut(row) {
            *x = auxiliary;
        }
    }
}

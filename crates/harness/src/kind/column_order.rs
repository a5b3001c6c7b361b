//! The order of columns whose law is not known, alike for every kind.

use crate::experiment::Terms;
use freepath_statistics::claim::{Claims, ColumnOrder};
use freepath_statistics::fold::RankedColumn;
use std::borrow::Cow;

/// A column whose rows are claimed to be independent.
pub(super) struct OrderedColumn {
    /// Its name.
    pub(super) name: Cow<'static, str>,
    /// The words before the names of its tests, if others of the subject have the same.
    pub(super) prefix: String,
    /// Infinite rows are escapes.
    pub(super) escapes: bool,
}

impl OrderedColumn {
    /// The only column of a row that has an order.
    pub(super) fn only(name: &'static str) -> Self {
        Self { name: name.into(), prefix: String::new(), escapes: false }
    }

    /// A column of distances.
    pub(super) fn distances(name: &'static str) -> Self {
        Self { escapes: true, ..Self::only(name) }
    }

    /// One of several columns of weights.
    pub(super) fn weights(name: Cow<'static, str>) -> Self {
        Self { prefix: format!("{name}_"), name, escapes: false }
    }

    /// Claims that the rows are independent of one another, and alike along the run.
    pub(super) fn claim(self, external: bool, terms: &Terms, claims: &mut Claims) {
        let Self { name, prefix, escapes } = self;
        let column = claims.folds.add(RankedColumn::new(name, escapes, terms.ordered_rows(external)));
        claims.push(ColumnOrder { prefix, column, escapes });
    }
}

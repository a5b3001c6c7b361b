use super::{Fold, Merge};
use crate::block::{Block, Scratch};
use freepath_draws::MissingColumn;
use std::sync::Arc;

/// A predicate: true where the columns of a row, in their order, may lie.
pub type Inside = Arc<dyn Fn(&[f64]) -> bool + Send + Sync>;

/// Rows that lie where they may not, and those that are atoms.
pub struct Places {
    /// The columns.
    pub columns: &'static [&'static str],
    /// The places where a row that is no atom may lie.
    pub inside: Inside,
    /// The atoms of the first column.
    pub atoms: Vec<f64>,
}

/// Counts of rows by where they lie.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PlaceCounts {
    /// NaN in any column.
    pub non_finite: u64,
    /// Rows where there is no mass.
    pub outside: u64,
    /// At each atom.
    pub atoms: Vec<u64>,
}

impl Merge for PlaceCounts {
    fn merge(&mut self, other: &Self) {
        self.non_finite += other.non_finite;
        self.outside += other.outside;
        self.atoms.iter_mut().zip(&other.atoms).for_each(|(count, more)| *count += more);
    }
}

impl Fold for Places {
    type Counts = PlaceCounts;
    type Sums = ();

    fn empty(&self) -> PlaceCounts {
        PlaceCounts { atoms: vec![0; self.atoms.len()], ..PlaceCounts::default() }
    }
    fn no_sums(&self) {}
    fn observe(&self, block: &Block, _: &mut Scratch, counts: &mut PlaceCounts) -> Result<(), MissingColumn> {
        block.for_each_row(self.columns, |row| {
            let is_here = |atom: &f64| row.first().is_some_and(|x| x.total_cmp(atom).is_eq());
            match self.atoms.iter().position(is_here) {
                Some(atom) => counts.atoms[atom] += 1,
                None if row.iter().any(|x| x.is_nan()) => counts.non_finite += 1,
                None => counts.outside += u64::from(!(self.inside)(row)),
            }
        })
    }
}

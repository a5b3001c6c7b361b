use super::{Fold, Merge};
use crate::block::{Block, Scratch};
use freepath_draws::MissingColumn;
use std::sync::Arc;

/// Where a column may lie.
pub type Inside = Arc<dyn Fn(f64) -> bool + Send + Sync>;

/// Numbers of a column that lie where they may not, and those that are atoms.
pub struct Places {
    /// The column.
    pub column: &'static str,
    /// Where a number that is no atom may lie.
    pub inside: Inside,
    /// The atoms.
    pub atoms: Vec<f64>,
}

/// How many numbers lie where.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PlaceCounts {
    /// NaN.
    pub non_finite: u64,
    /// Where there is no mass.
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
        for &x in block.f64(self.column)? {
            match self.atoms.iter().position(|atom| x.total_cmp(atom).is_eq()) {
                Some(atom) => counts.atoms[atom] += 1,
                None if x.is_nan() => counts.non_finite += 1,
                None => counts.outside += u64::from(!(self.inside)(x)),
            }
        }
        Ok(())
    }
}

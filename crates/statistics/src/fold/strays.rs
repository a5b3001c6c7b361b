use super::{Fold, Merge};
use crate::block::{Block, Scratch};
use freepath_draws::MissingColumn;

/// Distances that no law counts: of a column whose law is not claimed.
pub struct Strays {
    /// The column.
    pub column: &'static str,
    /// The far end of the ray; infinity is an escape.
    pub length: f64,
}

/// Counts of distances that are wrong for certain.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StrayCounts {
    /// NaN.
    pub non_finite: u64,
    /// Outside the ray.
    pub out_of_support: u64,
}

impl Merge for StrayCounts {
    fn merge(&mut self, other: &Self) {
        self.non_finite += other.non_finite;
        self.out_of_support += other.out_of_support;
    }
}

impl Fold for Strays {
    type Counts = StrayCounts;
    type Sums = ();

    fn empty(&self) -> StrayCounts {
        StrayCounts::default()
    }
    fn no_sums(&self) {}
    fn observe(&self, block: &Block, _: &mut Scratch, counts: &mut StrayCounts) -> Result<(), MissingColumn> {
        let inside = |t: f64| (t >= 0.0 && t <= self.length) || t == f64::INFINITY;
        for &t in block.f64(self.column)? {
            counts.non_finite += u64::from(t.is_nan());
            counts.out_of_support += u64::from(!t.is_nan() && !inside(t));
        }
        Ok(())
    }
}

use super::{Fold, Merge};
use crate::block::{Block, Scratch};
use freepath_draws::MissingColumn;
use std::borrow::Cow;
use std::sync::Arc;

/// The weights that belong to a distance, infinity for the end of the ray, one for each column.
pub type WeightsOf = Arc<dyn Fn(f64, &mut [f64]) + Send + Sync>;

/// Rows whose weights are not the function of the distance that they should be, among the first blocks.
pub struct WeightIdentity {
    /// The columns of weights.
    pub columns: Vec<Cow<'static, str>>,
    /// The column of distances.
    pub distance: &'static str,
    /// The function.
    pub weights: WeightsOf,
    /// The most by which a weight may be off, relative to itself.
    pub relative: f64,
    /// The same, whatever its size.
    pub absolute: f64,
}

/// Counts of rows that were looked at.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WeighedRows {
    /// All of them.
    pub looked: u64,
    /// Those with another weight.
    pub other: u64,
}

impl Merge for WeighedRows {
    fn merge(&mut self, other: &Self) {
        self.looked += other.looked;
        self.other += other.other;
    }
}

impl WeightIdentity {
    fn is_other(&self, seen: f64, due: f64) -> bool {
        !((seen - due).abs() <= self.relative * due.abs() + self.absolute)
    }
}

impl Fold for WeightIdentity {
    type Counts = WeighedRows;
    type Sums = ();

    fn empty(&self) -> WeighedRows {
        WeighedRows::default()
    }
    fn no_sums(&self) {}
    fn observe(&self, block: &Block, _: &mut Scratch, counts: &mut WeighedRows) -> Result<(), MissingColumn> {
        if !block.is_early() {
            return Ok(());
        }
        let columns: Vec<&[f64]> =
            self.columns.iter().map(|column| block.f64(column)).collect::<Result<_, _>>()?;
        let mut due = vec![f64::NAN; columns.len()];
        for (row, &t) in block.f64(self.distance)?.iter().enumerate() {
            (self.weights)(t, &mut due);
            let other = columns.iter().zip(&due).any(|(column, &due)| self.is_other(column[row], due));
            counts.other += u64::from(other);
            counts.looked += 1;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_draws::{Draws, Row};

    fn counted(weight: f64, t: f64) -> WeighedRows {
        let fold = WeightIdentity {
            columns: vec!["channel_0".into()],
            distance: "t",
            weights: Arc::new(|t: f64, due: &mut [f64]| due[0] = if t.is_finite() { 3.0 * t } else { 0.5 }),
            relative: 1e-9,
            absolute: 0.0,
        };
        let mut draws = Draws::new(&Row::new().with_f64("t").with_f64("channel_0"), 1);
        draws.f64_mut("t").expect("distances")[0] = t;
        draws.f64_mut("channel_0").expect("weights")[0] = weight;
        let block = Block { draws: &draws, number: 7, nth: 0, audit: None };
        let mut counts = fold.empty();
        fold.observe(&block, &mut Scratch::default(), &mut counts).expect("both columns");
        counts
    }

    #[test]
    fn a_weight_is_that_of_its_distance_or_counted() {
        let of = |weight, t| counted(weight, t).other;
        assert_eq!((of(1.5, 0.5), of(1.5 * (1.0 + 1e-10), 0.5), of(0.5, f64::INFINITY)), (0, 0, 0));
        assert_eq!((of(1.5 * (1.0 + 1e-8), 0.5), of(f64::NAN, 0.5), of(1.5, f64::NAN)), (1, 1, 1));
        assert_eq!(counted(1.5, 0.5).looked, 1);
    }
}

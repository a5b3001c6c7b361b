use super::Listed;
use std::collections::BTreeSet;

/// 1 - M = L U by elimination row by row, without exchanges: none is needed where the spectral radius of |M| is below 1, since pivots are then at
/// least those of 1 - |M|, all positive (Fiedler and Ptak 1962). What is 0 stays away, so that bands stay bands.
pub(super) struct Factor {
    /// Below the diagonal, whose entries are 1.
    lower: Vec<Vec<(usize, f64)>>,
    pivots: Vec<f64>,
    /// Beyond the diagonal.
    upper: Vec<Vec<(usize, f64)>>,
}

/// Most entries of L and U.
const MOST: usize = 1 << 24;

impl Factor {
    /// None if a pivot is 0 or NaN, or L and U would have more than 2^24 entries.
    pub(super) fn of(matrix: &Listed) -> Option<Self> {
        let n = matrix.states();
        let mut factor = Self { lower: Vec::new(), pivots: Vec::new(), upper: Vec::new() };
        let (mut row, mut filled) = (vec![0.0; n], 0);
        for i in 0..n {
            let mut columns: BTreeSet<usize> = matrix.columns(i).iter().copied().chain([i]).collect();
            matrix.row(i).for_each(|(j, entry)| row[j] -= entry);
            row[i] += 1.0;
            factor.eliminate(i, &mut row, &mut columns)?;
            filled += columns.len();
            columns.into_iter().for_each(|j| row[j] = 0.0);
            if filled > MOST {
                return None;
            }
        }
        Some(factor)
    }

    /// Takes from row `i` the multiples of those above it.
    fn eliminate(&mut self, i: usize, row: &mut [f64], columns: &mut BTreeSet<usize>) -> Option<()> {
        let (mut lower, mut from) = (Vec::new(), 0);
        while let Some(&k) = columns.range(from..i).next() {
            from = k + 1;
            let multiple = row[k] / self.pivots[k];
            if multiple != 0.0 {
                lower.push((k, multiple));
                for &(j, entry) in &self.upper[k] {
                    row[j] -= multiple * entry;
                    columns.insert(j);
                }
            }
        }
        let pivot = row[i];
        self.lower.push(lower);
        self.pivots.push(pivot);
        self.upper.push(columns.range(i + 1..).map(|&j| (j, row[j])).collect());
        (pivot != 0.0 && pivot.is_finite()).then_some(())
    }

    /// x with L U x = `right`.
    pub(super) fn solved(&self, right: &[f64]) -> Vec<f64> {
        let mut x = right.to_vec();
        for (i, lower) in self.lower.iter().enumerate() {
            x[i] -= lower.iter().map(|&(k, multiple)| multiple * x[k]).sum::<f64>();
        }
        for (i, upper) in self.upper.iter().enumerate().rev() {
            x[i] = (x[i] - upper.iter().map(|&(j, entry)| entry * x[j]).sum::<f64>()) / self.pivots[i];
        }
        x
    }

    pub(super) fn least_pivot(&self) -> f64 {
        self.pivots.iter().fold(f64::INFINITY, |least, &pivot| if pivot >= least { least } else { pivot })
    }
}

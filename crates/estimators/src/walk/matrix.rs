use factor::Factor;
pub use listed::Listed;

mod factor;
mod listed;

/// A square matrix over the states of a walk.
#[derive(Clone, Debug, PartialEq)]
pub enum Matrix {
    /// By its entries.
    Listed(Listed),
    /// Every entry is the same: n^2 entries in two numbers.
    Alike {
        /// n.
        states: usize,
        /// The entry.
        value: f64,
    },
}

impl Matrix {
    /// Its rows.
    #[must_use]
    pub fn states(&self) -> usize {
        match self {
            Self::Listed(listed) => listed.states(),
            Self::Alike { states, .. } => *states,
        }
    }

    /// The same places, each entry changed.
    #[must_use]
    pub fn map(&self, change: impl Fn(f64) -> f64) -> Self {
        match self {
            Self::Listed(listed) => Self::Listed(listed.map(change)),
            Self::Alike { states, value } => Self::Alike { states: *states, value: change(*value) },
        }
    }

    /// The entries at the same places of this and another matrix of the same places, combined.
    #[must_use]
    pub fn with(&self, other: &Self, combine: impl Fn(f64, f64) -> f64) -> Self {
        match (self, other) {
            (Self::Listed(one), Self::Listed(two)) => Self::Listed(one.with(two, combine)),
            (Self::Alike { states, value }, Self::Alike { value: other, .. }) => {
                Self::Alike { states: *states, value: combine(*value, *other) }
            }
            (Self::Listed(one), Self::Alike { value, .. }) => {
                Self::Listed(one.map(|entry| combine(entry, *value)))
            }
            (Self::Alike { value, .. }, Self::Listed(two)) => {
                Self::Listed(two.map(|entry| combine(*value, entry)))
            }
        }
    }

    /// Rows and columns exchanged.
    #[must_use]
    pub fn transposed(&self) -> Self {
        match self {
            Self::Listed(listed) => Self::Listed(listed.transposed()),
            Self::Alike { .. } => self.clone(),
        }
    }

    /// The sum of each row.
    #[must_use]
    pub fn row_sums(&self) -> Vec<f64> {
        self.times(&vec![1.0; self.states()])
    }

    /// M x.
    #[must_use]
    pub fn times(&self, x: &[f64]) -> Vec<f64> {
        match self {
            Self::Listed(listed) => {
                (0..x.len()).map(|i| listed.row(i).map(|(j, entry)| entry * x[j]).sum()).collect()
            }
            Self::Alike { value, .. } => vec![value * x.iter().sum::<f64>(); x.len()],
        }
    }

    /// x M.
    #[must_use]
    pub fn left(&self, x: &[f64]) -> Vec<f64> {
        match self {
            Self::Listed(listed) => {
                let mut product = vec![0.0; x.len()];
                for (i, &x) in x.iter().enumerate().filter(|(_, x)| **x != 0.0) {
                    listed.row(i).for_each(|(j, entry)| product[j] += x * entry);
                }
                product
            }
            Self::Alike { .. } => self.times(x),
        }
    }

    /// x = M x + `right`; none if elimination without pivots meets 0, or fills more than it may.
    #[must_use]
    pub fn solved(&self, right: &[f64]) -> Option<Vec<f64>> {
        match self {
            Self::Alike { states, value } => {
                let rest = 1.0 - *states as f64 * value;
                let share = value * right.iter().sum::<f64>() / rest;
                (rest != 0.0).then(|| right.iter().map(|b| b + share).collect())
            }
            Self::Listed(listed) => {
                let factor = Factor::of(listed)?;
                let mut x = factor.solved(right);
                // one step of refinement brings the residual to rounding
                let back = self.times(&x);
                let residual: Vec<f64> =
                    right.iter().zip(&x).zip(back).map(|((b, x), back)| b + back - x).collect();
                x.iter_mut().zip(factor.solved(&residual)).for_each(|(x, more)| *x += more);
                Some(x)
            }
        }
    }

    /// True of a matrix without negative entries if its spectral radius is below 1: all pivots of 1 - M are positive (Fiedler and
    /// Ptak 1962), which needs no iteration.
    #[must_use]
    pub fn contracts(&self) -> bool {
        match self {
            Self::Alike { states, value } => *states as f64 * value < 1.0,
            Self::Listed(listed) => Factor::of(listed).is_some_and(|factor| factor.least_pivot() > LEAST_PIVOT),
        }
    }

    /// The spectral radius of a matrix without negative entries, to about 1e-9, by powers of M + 1, which has no period.
    #[must_use]
    pub fn radius(&self) -> f64 {
        let mut x = vec![1.0; self.states()];
        let mut radius = 0.0;
        for _ in 0..POWERS {
            let next: Vec<f64> = self.times(&x).iter().zip(&x).map(|(more, x)| more + x).collect();
            let norm: f64 = next.iter().sum();
            let before = std::mem::replace(&mut radius, norm / x.iter().sum::<f64>() - 1.0);
            x = next.iter().map(|x| x / norm).collect();
            if (radius - before).abs() <= 1e-13 {
                break;
            }
        }
        radius
    }
}

/// A pivot below it is one of a radius of 1, but for rounding.
const LEAST_PIVOT: f64 = 1e-13;
/// Most powers.
const POWERS: usize = 20_000;

#[cfg(test)]
mod tests {
    use super::*;

    fn dense(rows: &[&[f64]]) -> Matrix {
        let rows: Vec<Vec<(usize, f64)>> =
            rows.iter().map(|row| row.iter().copied().enumerate().collect()).collect();
        Matrix::Listed(Listed::of(&rows))
    }

    #[test]
    fn a_solution_is_that_of_its_rows() {
        let matrix = dense(&[&[0.5, -0.6], &[0.6, 0.5]]);
        let x = matrix.solved(&[1.0, 1.0]).unwrap();
        assert!((x[0] + 0.1 / 0.61).abs() < 1e-14 && (x[1] - 1.1 / 0.61).abs() < 1e-14, "{x:?}");
        let alike = Matrix::Alike { states: 4, value: 0.2 };
        assert!(alike.solved(&[1.0; 4]).unwrap().iter().all(|x| (x - 5.0).abs() < 1e-13));
    }

    #[test]
    fn a_radius_below_1_is_told_from_one_of_1() {
        let swap = |rate| dense(&[&[0.0, rate], &[rate, 0.0]]);
        assert!(swap(0.999_999).contracts() && !swap(1.0).contracts() && !swap(1.62).contracts());
        assert!((swap(0.9).radius() - 0.9).abs() < 1e-9 && dense(&[&[0.0]]).contracts());
        assert!(!Matrix::Alike { states: 10, value: 0.1 }.contracts());
    }

    #[test]
    fn a_closed_class_is_found_wherever_it_stands() {
        assert!(!dense(&[&[0.5, 0.0, 0.2], &[0.0, 0.0, 1.0], &[0.0, 1.0, 0.0]]).contracts());
    }

    #[test]
    fn products_from_both_sides_are_those_of_the_transposed() {
        let matrix = dense(&[&[0.1, 0.2], &[0.3, 0.4]]);
        assert_eq!(matrix.left(&[1.0, 2.0]), matrix.transposed().times(&[1.0, 2.0]));
    }
}

use super::Picked;
use freepath_draws::CompensatedSum;
use std::collections::VecDeque;

/// Cells of one size, each shared by two categories at the most (Walker 1977), paired in linear time (Vose 1991).
///
/// ```text
/// mass of i = (keep_i + sum over j with alias_j = i of (1 - keep_j)) / n
/// ```
///
/// Weights of which one is a multiple of the other make ties: they are told exactly, since no weight is divided before it is compared.
#[derive(Clone, Debug, PartialEq)]
pub struct AliasTable {
    /// The share of each cell that its own category keeps.
    pub keep: Vec<f64>,
    /// The category that has the rest.
    pub alias: Vec<usize>,
}

impl AliasTable {
    /// The table of weights that sum up to `total`.
    #[must_use]
    pub fn new(weights: &[f64], total: f64) -> Self {
        Self::paired_while(weights, total, |_| true)
    }

    /// The same, paired as long as `goes_on` holds of n w, less what was given away, of the category that has given last; all cells
    /// that are left keep what they have.
    #[must_use]
    pub fn paired_while(weights: &[f64], total: f64, goes_on: impl Fn(f64) -> bool) -> Self {
        let n = weights.len();
        let mut rest: Vec<CompensatedSum> = weights.iter().map(|weight| sum_of(n as f64 * weight)).collect();
        let mut table = Self { keep: vec![1.0; n], alias: (0..n).collect() };
        // a category of just its share neither gives nor takes
        let (mut light, mut heavy) = (VecDeque::new(), VecDeque::new());
        for (i, own) in rest.iter().enumerate() {
            if own.value() < total {
                light.push_back(i);
            } else if own.value() > total {
                heavy.push_back(i);
            }
        }
        while let (Some(&taker), Some(&giver)) = (light.front(), heavy.front()) {
            light.pop_front();
            let own = rest[taker].value();
            (table.keep[taker], table.alias[taker]) = (own / total, giver);
            rest[giver].add(own);
            rest[giver].add(-total);
            let left = rest[giver].value();
            if left <= total {
                heavy.pop_front();
            }
            if left < total {
                light.push_back(giver);
            }
            if !goes_on(left) {
                break;
            }
        }
        table
    }

    /// The category of a uniform `u` in [0, 1): n u is below n in double precision, too, as the largest u is 1 - 2^-53.
    #[inline]
    #[must_use]
    pub fn pick(&self, u: f64) -> Picked {
        let at = u * self.keep.len() as f64;
        let cell = at as usize;
        let (place, keep) = (at - cell as f64, self.keep[cell]);
        if place < keep {
            Picked::inside(cell, place, 0.0, keep)
        } else {
            Picked::inside(self.alias[cell], place, keep, 1.0)
        }
    }

    /// The probability of each category.
    #[must_use]
    pub fn masses(&self) -> Vec<f64> {
        let mut masses = vec![CompensatedSum::default(); self.keep.len()];
        for (cell, (&keep, &alias)) in self.keep.iter().zip(&self.alias).enumerate() {
            masses[cell].add(keep);
            masses[alias].add(1.0 - keep);
        }
        masses.iter().map(|mass| mass.value() / masses.len() as f64).collect()
    }
}

fn sum_of(term: f64) -> CompensatedSum {
    let mut sum = CompensatedSum::default();
    sum.add(term);
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    fn off(weights: &[f64]) -> f64 {
        let mut total = CompensatedSum::default();
        weights.iter().for_each(|weight| total.add(*weight));
        let total = total.value();
        let masses = AliasTable::new(weights, total).masses();
        let off = masses.iter().zip(weights).map(|(mass, weight)| (mass - weight / total).abs());
        off.fold(0.0, |a, b| if b <= a { a } else { b })
    }

    #[test]
    fn masses_are_the_weights_to_rounding() {
        let harmonic: Vec<f64> = (1..=100_000).map(|i| 1.0 / f64::from(i)).collect();
        let one = |i: u32| if i == 700 { 1.0 } else { 1e-6 };
        let dominant: Vec<f64> = (0..100_000).map(one).collect();
        let rising: Vec<f64> = (1..=1000).map(f64::from).collect();
        let decades: Vec<f64> = (0..13).map(|i| libm::exp10(-f64::from(i))).collect();
        let mut tables: Vec<Vec<f64>> = vec![harmonic, dominant, rising, decades, vec![1e8; 50], vec![3.0]];
        tables.extend([vec![10.0, 10.0, 1.0, 1.0], vec![0.0, 3.0, 0.0, 1.0, 4.0, 2.0, 0.0], vec![1.0, 1e-300]]);
        for weights in tables {
            assert!(off(&weights) <= 4.0 * f64::EPSILON, "{} weights: off by {:e}", weights.len(), off(&weights));
        }
    }

    #[test]
    fn the_last_uniform_lies_in_the_last_cell() {
        for n in [1, 3, 7, 1000, 65_536, 99_999, 1 << 20] {
            let table = AliasTable { keep: vec![1.0; n], alias: (0..n).collect() };
            for u in [1.0 - 0.5 * f64::EPSILON, 1.0 - f64::EPSILON, 0.0] {
                let Picked { index, remapped } = table.pick(u);
                assert_eq!(index, if u > 0.5 { n - 1 } else { 0 });
                assert!((0.0..1.0).contains(&remapped), "{n} {u} {remapped}");
            }
        }
    }

    #[test]
    fn a_category_of_weight_0_has_no_piece() {
        let table = AliasTable::new(&[0.0, 3.0, 0.0, 1.0, 4.0, 2.0, 0.0], 10.0);
        assert!((0..70_000).all(|i| ![0, 2, 6].contains(&table.pick(f64::from(i) / 70_000.0).index)));
    }
}

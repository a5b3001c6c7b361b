//! The left tail of Pearson's chi-square of equal cells, by enumeration.

/// Equal cells that expect so many draws each, a whole number.
#[derive(Clone, Copy, Debug)]
pub struct EqualCells {
    /// How many.
    pub count: usize,
    /// The expectation of each.
    pub each: u32,
}

impl EqualCells {
    /// P(sum (O - E)^2 / E <= x): Poisson counts given their sum.
    ///
    /// ```text
    /// ways(s, q) = sum_d P(O = E + d) ways'(s - d, q - d^2),   s = sum d,   q = sum d^2 <= x E
    /// ```
    #[must_use]
    pub fn at_most(self, x: f64) -> f64 {
        let most = (x * f64::from(self.each)).floor() as usize;
        let reach = (most as f64 * self.count as f64).sqrt() as usize + 1; // |sum d| <= sqrt(cells sum d^2)
        let mut ways = Ways::start(reach, most);
        let pmf = self.pmf((most as f64).sqrt() as i64);
        for _ in 0..self.count {
            ways = ways.with_a_cell(&pmf);
        }
        let total = f64::from(self.each) * self.count as f64;
        let of_total = libm::exp(total * libm::log(total) - total - libm::lgamma(total + 1.0));
        ways.balanced() / of_total
    }

    /// (d, P(O = E + d)) for the d that may be.
    fn pmf(self, most: i64) -> Vec<(i64, f64)> {
        let each = f64::from(self.each);
        let p = |d: i64| {
            let k = each + d as f64;
            libm::exp(k * libm::log(each) - each - libm::lgamma(k + 1.0))
        };
        (-most..=most).filter(|d| each + *d as f64 >= 0.0).map(|d| (d, p(d))).collect()
    }
}

/// Probabilities by the sum of the differences and of their squares.
struct Ways {
    reach: usize,
    most: usize,
    table: Vec<f64>,
}

impl Ways {
    fn start(reach: usize, most: usize) -> Self {
        let mut table = vec![0.0; (2 * reach + 1) * (most + 1)];
        table[reach * (most + 1)] = 1.0;
        Self { reach, most, table }
    }

    fn with_a_cell(&self, pmf: &[(i64, f64)]) -> Self {
        let (row, rows) = (self.most + 1, 2 * self.reach as i64 + 1);
        let mut table = vec![0.0; self.table.len()];
        for &(d, p) in pmf {
            let square = (d * d) as usize;
            for to in (0..rows).filter(|to| (0..rows).contains(&(to - d))) {
                let from = &self.table[(to - d) as usize * row..][..row - square];
                let into = &mut table[to as usize * row + square..][..row - square];
                into.iter_mut().zip(from).for_each(|(into, from)| *into += p * from);
            }
        }
        Self { table, ..*self }
    }

    /// The probability that the differences sum to 0.
    fn balanced(&self) -> f64 {
        self.table[self.reach * (self.most + 1)..][..=self.most].iter().sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use freepath_statistics::special::{binomial_cdf, chi_square_cdf};

    #[test]
    fn two_cells_give_the_binomial_law() {
        let exact = 1.0 - 2.0 * binomial_cdf(100, 0.5, 46); // 47 to 53
        let enumerated = EqualCells { count: 2, each: 50 }.at_most(9.5 * 2.0 / 50.0);
        assert!((enumerated / exact - 1.0).abs() < 1e-10, "{enumerated} {exact}");
    }

    #[test]
    fn the_left_tail_of_33_cells_of_50_is_true_to_a_few_percent() {
        for level in [1e-3, 1e-6, 1e-8, 1e-12] {
            let x = (1..10_000).map(|q| f64::from(q) / 50.0).take_while(|x| chi_square_cdf(32.0, *x) <= level);
            let x = x.last().unwrap_or(0.0);
            let ratio = EqualCells { count: 33, each: 50 }.at_most(x) / level;
            println!("{level}: {ratio}");
            assert!(ratio > 0.6 && ratio < 1.08, "{level}: {ratio}");
        }
    }
}

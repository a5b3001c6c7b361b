/// A sum that remembers what its additions round off (Neumaier 1974): right to rounding, however many terms there are.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CompensatedSum {
    sum: f64,
    rounded_off: f64,
}

impl CompensatedSum {
    /// Adds one term.
    pub fn add(&mut self, term: f64) {
        let sum = self.sum + term;
        let lost = if self.sum.abs() >= term.abs() { (self.sum - sum) + term } else { (term - sum) + self.sum };
        self.sum = sum;
        self.rounded_off += lost;
    }

    /// The sum so far.
    #[must_use]
    pub fn value(&self) -> f64 {
        self.sum + self.rounded_off
    }
}

#[cfg(test)]
mod tests {
    use super::CompensatedSum;

    #[test]
    fn small_terms_are_not_lost_beside_a_large_one() {
        let mut sum = CompensatedSum::default();
        [1e16, 1.0, 1.0, 1.0, -1e16].into_iter().for_each(|term| sum.add(term));
        assert_eq!(sum.value().to_bits(), 3f64.to_bits());
        sum.add(f64::NAN);
        assert!(sum.value().is_nan());
    }
}

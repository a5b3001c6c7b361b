//! Laws of whole numbers.

use super::Law;
use crate::grain::Grain;
use freepath_draws::CompensatedSum;

impl Law {
    /// The law of whole numbers from 0 on: the number k has a cell of its own, from k to k + 1, in whose middle it is counted.
    ///
    /// Tails are summed from the far end, so that small masses there keep their digits.
    #[must_use]
    pub fn of_counts(masses: &[f64], slack: f64) -> Self {
        let mut survival = vec![0.0; masses.len() + 1];
        let mut sum = CompensatedSum::default();
        for (k, &mass) in masses.iter().enumerate().rev() {
            sum.add(mass);
            survival[k] = sum.value();
        }
        Self { length: masses.len() as f64, scale: 1.0, survival, slack, grain: Grain::default(), counts: true }
    }

    /// True if it is of whole numbers: a cell holds one of them alone, and nothing is hidden between its edges.
    #[must_use]
    pub fn is_of_counts(&self) -> bool {
        self.counts
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers_have_a_cell_each_and_hide_nothing() {
        let law = Law::of_counts(&[0.0, 0.3, 1e-12, 0.7 - 1e-12], 0.0);
        assert!(law.cells() == 4 && law.edge(4) >= 4.0 && law.is_of_counts());
        assert!((law.mass(2) / 1e-12 - 1.0).abs() < 1e-3 && law.mass(0) <= 0.0 && law.atom() <= 0.0);
        assert!((law.collided() - 1.0).abs() < 1e-15 && (law.mass(1) - 0.3).abs() < 1e-15);
    }
}

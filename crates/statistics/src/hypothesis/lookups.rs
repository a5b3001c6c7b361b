use super::chi_square::lessened;
use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass};
use crate::special::student_t_two_sided;
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "lookups",
    words: "The look-ups per draw, as the audit counted them block by block, have the mean that the method must have \
(Student's t over block totals).",
    details: "\
```text
t = (mean block total - expected) / (sd / sqrt(blocks))
p = exp(-|total - expected| / (1 + cost of a draw)) if the cost does not vary
```
Gate:    a mean that quadrature knows to 1e-6, 20 blocks, and a variance of the total of 400 squared costs.
Rejects: as wrong_cost: one look-up too many at the end, cached values, another majorant.",
    nulls: &[NullClass::Uniform, NullClass::Conservative],
    alone: Alone::No,
    section: "lookups",
};

/// Look-ups of each block, as integers: they merge in any order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BlockLookups {
    /// The number of blocks.
    pub blocks: u64,
    /// The sum over blocks.
    pub sum: u128,
    /// The sum of squares.
    pub squares: u128,
}

impl BlockLookups {
    /// Adds one block.
    pub fn observe(&mut self, lookups: u64) {
        let lookups = u128::from(lookups);
        self.merge(&Self { blocks: 1, sum: lookups, squares: lookups * lookups });
    }

    /// True if, blocks being alike, every draw must have cost the same: nothing, or a whole number in each of several
    /// blocks, which draws of random cost seldom add up to.
    fn steady(&self, rows: usize) -> bool {
        let whole = self.sum.is_multiple_of(u128::from(self.blocks) * rows as u128);
        self.sum == 0 || (self.blocks >= 3 && whole)
    }

    /// Adds the blocks of another worker.
    pub fn merge(&mut self, other: &Self) {
        self.blocks += other.blocks;
        self.sum += other.sum;
        self.squares += other.squares;
    }
}

/// Fewest blocks for Student's t.
const FEWEST_BLOCKS: u64 = 20;
/// Least variance of the sum of all draws, in units of the square of what a rare draw changes: 1 / 0.03^2.
const LEAST_VARIANCE: f64 = 1111.0;

/// The most that quadrature may leave of a cost, in look-ups and relative to it.
const MOST_LEFT: f64 = 1e-6;

/// The cost of a draw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cost {
    /// Its mean, in look-ups.
    pub expected: f64,
    /// How far quadrature may put it off.
    pub error: f64,
    /// How far it may be off.
    pub slack: f64,
}

/// The cost law, over blocks of `rows` draws.
///
/// A cost that does not vary is held against the chance that all `n` draws cost the same although the mean says otherwise:
///
/// ```text
/// p = exp(-|total - n expected| / c),   c = 1 + the cost of a draw, the most that a rare draw is taken to change
/// ```
///
/// It is withheld where quadrature leaves more than 1e-6 of the cost; Student's t where what varies may be a few such rare draws, variance of all n draws < 1111 c^2: the skewness of their
/// sum may then be above 0.03, where p-values of 1e-7 come three times too often.
#[must_use]
pub fn lookups(seen: &BlockLookups, rows: usize, cost: Cost) -> Evidence {
    let Cost { expected, error, slack } = cost;
    let (blocks, want) = (seen.blocks as f64, expected * rows as f64);
    let mean = seen.sum as f64 / blocks;
    let excess = lessened(mean - want, (slack + error) * rows as f64 + 1e-9 * (want + 1.0));
    if !(error <= MOST_LEFT * (1.0 + expected)) {
        let why = format!("quadrature leaves {error:.1e} of the {expected:.3} look-ups unknown");
        return Evidence::withheld(TEST.name, excess, Reason::WrongCost, why);
    }
    let evidence = |statistic, dof, p| Evidence::new(TEST.name, statistic, dof, p, Reason::WrongCost);
    let largest = 1.0 + (if mean > want { mean } else { want }) / rows as f64;
    let scatter = seen.squares * u128::from(seen.blocks) - seen.sum * seen.sum;
    if scatter == 0 && (excess == 0.0 || seen.steady(rows)) {
        return evidence(excess, None, libm::exp(-blocks * excess.abs() / largest)).under(Null::Conservative);
    }
    let variance = scatter as f64 / (blocks * (blocks - 1.0));
    if seen.blocks < FEWEST_BLOCKS || !(blocks * variance >= LEAST_VARIANCE * largest * largest) {
        let why = "fewer than 20 blocks, or too few draws whose cost differs";
        return Evidence::withheld(TEST.name, excess, Reason::WrongCost, why);
    }
    let t = excess / (variance / blocks).sqrt();
    evidence(t, Some(blocks - 1.0), student_t_two_sided(blocks - 1.0, t))
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROWS: u64 = 16_384;

    fn p(totals: &[u64], expected: f64) -> Option<f64> {
        let mut seen = BlockLookups::default();
        totals.iter().for_each(|&total| seen.observe(total));
        lookups(&seen, ROWS as usize, Cost { expected, error: 0.0, slack: 0.0 }).p
    }

    #[test]
    fn a_doubled_look_up_is_rejected() {
        let totals: Vec<u64> = (0..60).map(|i| ROWS + (i * 37) % 101).collect();
        assert!(p(&totals, 1.003) > Some(1e-3));
        assert!(p(&totals, 0.5) < Some(1e-12));
    }

    #[test]
    fn a_fixed_cost_is_compared_exactly() {
        assert_eq!(p(&[8 * ROWS; 5], 8.0), Some(1.0));
        assert_eq!(p(&[8 * ROWS], 8.0), Some(1.0));
        assert_eq!(p(&[8 * ROWS; 5], 7.0), Some(0.0));
        assert_eq!(p(&[0], 2.0), Some(0.0), "never a look-up");
    }

    #[test]
    fn one_block_of_random_cost_says_nothing() {
        assert_eq!(p(&[ROWS + 77], 1.0), None);
    }

    #[test]
    fn a_cost_that_quadrature_does_not_know_says_nothing() {
        let mut seen = BlockLookups::default();
        (0..5).for_each(|_| seen.observe(8 * ROWS));
        let judged = |error| lookups(&seen, ROWS as usize, Cost { expected: 8.000_001, error, slack: 0.0 }).p;
        assert!(judged(0.0) < Some(1.0) && judged(2e-6) == Some(1.0));
        assert_eq!([1e-3, f64::NAN].map(judged), [None, None]);
    }

    #[test]
    fn rare_changes_of_cost_are_not_missed_before_they_come() {
        assert!(p(&[0; 62], 1e-6) > Some(0.3));
        assert!(p(&[4 * ROWS; 62], 4.0 - 1e-6) > Some(0.3));
        assert_eq!(p(&[ROWS, ROWS + 1, ROWS], 1.0), None);
        assert!(p(&[4 * ROWS; 62], 4.0 - 1e-3) < Some(1e-9));
    }
}

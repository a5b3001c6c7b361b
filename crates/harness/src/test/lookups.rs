use crate::evidence::Evidence;
use crate::special::student_t_two_sided;
use crate::verdict::Reason;

pub(super) const WORDS: &str = "The look-ups per draw, as the audit counted them block by block, have the mean that the method must have \
(Student's t over block totals).";

/// Look-ups of each block, as integers: they merge in any order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BlockLookups {
    /// How many blocks.
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
        self.merge(&Self {
            blocks: 1,
            sum: lookups,
            squares: lookups * lookups,
        });
    }

    /// Adds the blocks of another worker.
    pub fn merge(&mut self, other: &Self) {
        self.blocks += other.blocks;
        self.sum += other.sum;
        self.squares += other.squares;
    }
}

/// The cost law: `expected` look-ups per draw, over blocks of `rows` draws.
#[must_use]
pub fn lookups(seen: &BlockLookups, rows: usize, expected: f64) -> Evidence {
    let (blocks, want) = (seen.blocks as f64, expected * rows as f64);
    let mean = seen.sum as f64 / blocks;
    let scatter = seen.squares * u128::from(seen.blocks) - seen.sum * seen.sum;
    let excess = mean - want;
    let exact = scatter == 0 && excess.abs() <= 1e-9 * (want + 1.0);
    if exact {
        return Evidence::new("lookups", excess, None, 1.0, Reason::WrongCost);
    }
    // A few blocks may agree by chance, and one always agrees with itself.
    if seen.blocks < 20 {
        return Evidence::withheld("lookups", excess, Reason::WrongCost, "fewer than 20 blocks");
    }
    if scatter == 0 {
        return Evidence::new("lookups", excess, None, 0.0, Reason::WrongCost);
    }
    let variance = scatter as f64 / (blocks * (blocks - 1.0));
    let t = excess / (variance / blocks).sqrt();
    Evidence::new(
        "lookups",
        t,
        Some(blocks - 1.0),
        student_t_two_sided(blocks - 1.0, t),
        Reason::WrongCost,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_doubled_look_up_is_rejected() {
        let mut seen = BlockLookups::default();
        (0..60).for_each(|i| seen.observe(16_384 + (i * 37) % 101));
        let p = |expected| lookups(&seen, 16_384, expected).p;
        assert!(p(1.003) > Some(1e-3));
        assert!(p(0.5) < Some(1e-12));
    }

    #[test]
    fn one_block_does_not_show_a_fixed_cost() {
        let mut seen = BlockLookups::default();
        seen.observe(8 * 16_384 + 1);
        assert_eq!(lookups(&seen, 16_384, 8.0).p, None);
    }

    #[test]
    fn a_fixed_cost_is_compared_exactly() {
        let mut seen = BlockLookups::default();
        (0..20).for_each(|_| seen.observe(8 * 16_384));
        assert_eq!(lookups(&seen, 16_384, 8.0).p, Some(1.0));
        assert_eq!(lookups(&seen, 16_384, 7.0).p, Some(0.0));
    }
}

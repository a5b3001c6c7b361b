use super::cells::ESCAPE;
use crate::law::Law;

/// Products of neighbouring draws in drawing order, in ranks of 15 bits so that the sum is an integer.
///
/// The score of a draw is F at the middle of its fine cell, of an escape the middle of [F(length), 1], less one half; in
/// units of 2^-15.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LagTally {
    /// The sum of (score - mean)(next score - mean), in units of 2^-30, over pairs within blocks.
    pub products: i64,
    /// How many pairs.
    pub pairs: u64,
}

const UNIT: f64 = 32768.0;

/// The scores of a law's cells.
#[derive(Clone, Debug)]
pub struct Scores {
    cells: Vec<i32>,
    escape: i32,
    variance: f64,
}

impl Scores {
    /// The scores under `law`, centred to the nearest unit.
    #[must_use]
    pub fn new(law: &Law) -> Self {
        let raw = |k: usize| (0.5 * (law.cdf(k) + law.cdf(k + 1)) * UNIT).round();
        let escape = ((1.0 - 0.5 * law.atom()) * UNIT).round();
        let cells: Vec<f64> = (0..law.cells()).map(raw).collect();
        let weighted = |f: &dyn Fn(f64) -> f64| {
            let inside: f64 = cells
                .iter()
                .enumerate()
                .map(|(k, &score)| law.mass(k) * f(score))
                .sum();
            inside + law.atom() * f(escape)
        };
        let mean = weighted(&|score| score).round();
        let offset = weighted(&|score| score - mean);
        let variance = weighted(&|score| (score - mean) * (score - mean)) - offset * offset;
        let centred = cells.iter().map(|score| (score - mean) as i32).collect();
        Self {
            cells: centred,
            escape: (escape - mean) as i32,
            variance,
        }
    }

    /// Variance of one score, in squared units.
    #[must_use]
    pub fn variance(&self) -> f64 {
        self.variance
    }

    #[inline(always)]
    fn of(&self, cell: u32) -> i32 {
        if cell == ESCAPE {
            self.escape
        } else {
            self.cells.get(cell as usize).copied().unwrap_or(0)
        }
    }
}

impl LagTally {
    /// Adds the pairs of one block, given the fine cell of each draw.
    pub fn observe(&mut self, scores: &Scores, index: &[u32]) {
        let Some((&first, rest)) = index.split_first() else {
            return;
        };
        let (mut previous, mut sum) = (i64::from(scores.of(first)), 0);
        for &cell in rest {
            let score = i64::from(scores.of(cell));
            sum += previous * score;
            previous = score;
        }
        self.products += sum;
        self.pairs += rest.len() as u64;
    }

    /// Adds the pairs of another worker.
    pub fn merge(&mut self, other: &Self) {
        self.products += other.products;
        self.pairs += other.pairs;
    }
}

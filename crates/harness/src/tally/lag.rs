use super::cells::ESCAPE;
use crate::law::Law;

/// Products of neighbouring draws in drawing order, in ranks of 15 bits so that the sums are integers.
///
/// The score of a draw is F at the middle of its fine cell, of an escape the middle of [F(length), 1], less the mean that
/// it has under the law; in units of 2^-15.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LagTally {
    /// The sum of score times next score over pairs within blocks.
    pub products: i128,
    /// How many pairs.
    pub pairs: u64,
    /// The sum of scores.
    pub sum: i128,
    /// The sum of squared scores.
    pub squares: i128,
    /// How many draws.
    pub draws: u64,
}

const UNIT: f64 = 32768.0;

/// The scores of a law's cells.
#[derive(Clone, Debug)]
pub struct Scores {
    cells: Vec<i32>,
    escape: i32,
}

impl Scores {
    /// The scores under `law`, centred to the nearest unit.
    #[must_use]
    pub fn new(law: &Law) -> Self {
        let raw = |k: usize| (0.5 * (law.cdf(k) + law.cdf(k + 1)) * UNIT).round();
        let escape = ((1.0 - 0.5 * law.atom()) * UNIT).round();
        let inside: f64 = (0..law.cells()).map(|k| law.mass(k) * raw(k)).sum();
        let mean = (inside + law.atom() * escape).round();
        let cells = (0..law.cells()).map(|k| (raw(k) - mean) as i32).collect();
        Self {
            cells,
            escape: (escape - mean) as i32,
        }
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
        let (mut previous, mut products, mut sum, mut squares) = (0, 0, 0, 0);
        for &cell in index {
            let score = i64::from(scores.of(cell));
            products += previous * score;
            sum += score;
            squares += score * score;
            previous = score;
        }
        let block = Self {
            products: i128::from(products),
            pairs: (index.len() as u64).saturating_sub(1),
            sum: i128::from(sum),
            squares: i128::from(squares),
            draws: index.len() as u64,
        };
        self.merge(&block);
    }

    /// Adds the pairs of another worker.
    pub fn merge(&mut self, other: &Self) {
        self.products += other.products;
        self.pairs += other.pairs;
        self.sum += other.sum;
        self.squares += other.squares;
        self.draws += other.draws;
    }
}

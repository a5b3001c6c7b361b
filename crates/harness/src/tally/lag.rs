use super::CellTally;
use super::cells::ESCAPE;
use crate::law::Law;

/// Products of neighbouring draws in drawing order, in ranks of 15 bits so that the sum is an integer.
///
/// The score of a draw is F at the middle of its fine cell, of an escape the middle of [F(length), 1], less one half; in
/// units of 2^-15.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LagTally {
    /// The sum of (score - mean)(next score - mean), in units of 2^-30, over pairs within blocks.
    pub products: i128,
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
    skewness: f64,
}

impl Scores {
    /// The scores under `law`, centred to the nearest unit.
    #[must_use]
    pub fn new(law: &Law) -> Self {
        let raw = |k: usize| (0.5 * (law.cdf(k) + law.cdf(k + 1)) * UNIT).round();
        let escape = ((1.0 - 0.5 * law.atom()) * UNIT).round();
        let cells: Vec<f64> = (0..law.cells()).map(raw).collect();
        let weighted = |f: &dyn Fn(f64) -> f64| {
            let inside: f64 = cells.iter().enumerate().map(|(k, &score)| law.mass(k) * f(score)).sum();
            inside + law.atom() * f(escape)
        };
        let mean = weighted(&|score| score).round();
        let offset = weighted(&|score| score - mean);
        let centred = |score: f64| score - mean - offset;
        let variance = weighted(&|score| centred(score) * centred(score));
        let third = weighted(&|score| centred(score) * centred(score) * centred(score));
        let whole = cells.iter().map(|score| (score - mean) as i32).collect();
        Self {
            cells: whole,
            escape: (escape - mean) as i32,
            variance,
            skewness: third / (variance * variance.sqrt()),
        }
    }

    /// Variance of one score, in squared units.
    #[must_use]
    pub fn variance(&self) -> f64 {
        self.variance
    }

    /// Skewness of one score; NaN if nothing varies.
    #[must_use]
    pub fn skewness(&self) -> f64 {
        self.skewness
    }

    /// The mean score of the draws in `tally`.
    #[must_use]
    pub fn mean_of(&self, tally: &CellTally) -> f64 {
        let scored = |(&count, &score): (&u64, &i32)| i128::from(count) * i128::from(score);
        let inside: i128 = tally.cells.iter().zip(&self.cells).map(scored).sum();
        let sum = inside + i128::from(tally.escapes) * i128::from(self.escape);
        sum as f64 / tally.draws() as f64
    }

    /// Variance and skewness of the scores of the draws in `tally`.
    #[must_use]
    pub fn spread_of(&self, tally: &CellTally) -> (f64, f64) {
        let (n, mean) = (tally.draws() as f64, self.mean_of(tally));
        let scored = tally.cells.iter().zip(&self.cells).chain([(&tally.escapes, &self.escape)]);
        let (mut second, mut third) = (0.0, 0.0);
        for (&count, &score) in scored.filter(|(count, _)| **count > 0) {
            let off = f64::from(score) - mean;
            second += count as f64 / n * off * off;
            third += count as f64 / n * off * off * off;
        }
        (second, third / (second * second.sqrt()))
    }

    #[inline(always)]
    fn of(&self, cell: u32) -> i32 {
        if cell == ESCAPE { self.escape } else { self.cells.get(cell as usize).copied().unwrap_or(0) }
    }
}

impl LagTally {
    /// Adds the pairs of one block, given the fine cell of each draw.
    pub fn observe(&mut self, scores: &Scores, index: &[u32]) {
        let Some((&first, rest)) = index.split_first() else {
            return;
        };
        let (mut previous, mut sum) = (i64::from(scores.of(first)), 0); // a block fits: 2^14 products of 2^30
        for &cell in rest {
            let score = i64::from(scores.of(cell));
            sum += previous * score;
            previous = score;
        }
        self.products += i128::from(sum);
        self.pairs += rest.len() as u64;
    }

    /// Adds the pairs of another worker.
    pub fn merge(&mut self, other: &Self) {
        self.products += other.products;
        self.pairs += other.pairs;
    }
}

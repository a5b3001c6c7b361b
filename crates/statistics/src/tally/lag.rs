use super::cells::{CellTally, ESCAPE, NOWHERE};
use crate::law::Law;

/// The lags that are tallied: 1 to this.
pub const LAGS: usize = 8;

/// Groups of ranks in the table of neighbours.
pub(crate) const RANK_GROUPS: usize = 16;

/// Products of draws a few places apart in drawing order, and a table of neighbours, in ranks of 12 bits so that all sums are
/// integers.
///
/// The score of a draw is F at the middle of its fine cell, of an escape the middle of [F(length), 1], less one half; in
/// units of 2^-12. The group of a draw is the sixteenth of [0, 1] in which that F lies.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LagTally {
    /// For each lag from 1 the sum of (score - mean)(later score - mean), in units of 2^-24, over pairs within blocks.
    pub products: [i128; LAGS],
    /// For each lag, how many pairs.
    pub pairs: [u64; LAGS],
    /// For each lag the sum of the scores, less the mean, of the rows at the ends of blocks, which are in one pair and not in two;
    /// twice that of a row which is in none.
    pub ends: [i128; LAGS],
    /// Row `a`, column `b`: draws of group a followed by one of group b, within blocks.
    pub neighbours: Box<[[u64; RANK_GROUPS]; RANK_GROUPS]>,
    /// The scores of a block.
    buffer: Vec<i16>,
    /// Their groups.
    groups: Vec<u8>,
}

const UNIT: f64 = 4096.0;

/// Products summed at a time: each is less than 2^23, so that they fit 32 bits.
const PART: usize = 256;

/// Tables of neighbours that are filled in turn.
const TURNS: usize = 4;

/// Moments of scores as drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// In units, from the mean of the law.
    pub mean: f64,
    /// In squared units.
    pub variance: f64,
    /// NaN if nothing varies.
    pub skewness: f64,
    /// As `skewness`; 3 of a normal law.
    pub kurtosis: f64,
}

/// The scores of a law's cells.
#[derive(Clone, Debug)]
pub struct Scores {
    /// Of no cell, of an escape, then of each cell: where `cell + 2` wraps to.
    table: Vec<i16>,
    /// The number that was subtracted from F.
    mean: i16,
    variance: f64,
    skewness: f64,
    escapes: bool,
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
        let whole = cells.iter().map(|score| (score - mean) as i16);
        Self {
            table: [0, (escape - mean) as i16].into_iter().chain(whole).collect(),
            mean: mean as i16,
            variance,
            skewness: third / (variance * variance.sqrt()),
            escapes: law.atom() > 0.0 && law.collided() > 0.0,
        }
    }

    /// True if the law has both escapes and collisions.
    #[must_use]
    pub fn has_escapes(&self) -> bool {
        self.escapes
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

    /// The sum of the scores of the draws in `tally`; 0 is that of a draw which is nowhere.
    #[must_use]
    pub fn sum_of(&self, tally: &CellTally) -> i128 {
        let scored = |(&count, &score): (&u64, &i16)| i128::from(count) * i128::from(score);
        let inside: i128 = tally.cells.iter().zip(&self.table[2..]).map(scored).sum();
        inside + i128::from(tally.escapes) * i128::from(self.of(ESCAPE))
    }

    /// The moments of the scores of the draws in `tally`.
    #[must_use]
    pub fn spread_of(&self, tally: &CellTally) -> Spread {
        let n = tally.draws() as f64;
        let (mean, nowhere) = (self.sum_of(tally) as f64 / n, tally.non_finite + tally.out_of_support);
        let scored = [&nowhere, &tally.escapes].into_iter().chain(&tally.cells).zip(&self.table);
        let (mut second, mut third, mut fourth) = (0.0, 0.0, 0.0);
        for (&count, &score) in scored.filter(|(count, _)| **count > 0) {
            let off = f64::from(score) - mean;
            second += count as f64 / n * off * off;
            third += count as f64 / n * off * off * off;
            fourth += count as f64 / n * (off * off) * (off * off);
        }
        let skewness = third / (second * second.sqrt());
        Spread { mean, variance: second, skewness, kurtosis: fourth / (second * second) }
    }

    #[inline(always)]
    fn of(&self, cell: u32) -> i16 {
        const _: () =
            assert!(NOWHERE.wrapping_add(2) == 0 && ESCAPE.wrapping_add(2) == 1, "the head of the table");
        self.table.get(cell.wrapping_add(2) as usize).copied().unwrap_or(0)
    }

    /// The group of a draw.
    pub(super) fn group_of(&self, cell: u32) -> usize {
        self.group(self.of(cell))
    }

    /// The group of each score.
    fn groups(&self, scores: &[i16], groups: &mut Vec<u8>) {
        groups.resize(scores.len(), 0);
        freepath_draws::simd::dispatch(
            #[inline(always)]
            || groups.iter_mut().zip(scores).for_each(|(group, &score)| *group = self.group(score) as u8),
        );
    }

    #[inline(always)]
    fn group(&self, score: i16) -> usize {
        let group = (score + self.mean) >> 8; // 4096 / 16 units; F = 1 is one too many
        if (group as usize) < RANK_GROUPS { group as usize } else { RANK_GROUPS - 1 }
    }
}

impl Default for LagTally {
    fn default() -> Self {
        let neighbours = Box::new([[0; RANK_GROUPS]; RANK_GROUPS]);
        let (products, pairs, ends) = ([0; LAGS], [0; LAGS], [0; LAGS]);
        Self { products, pairs, ends, neighbours, buffer: Vec::new(), groups: Vec::new() }
    }
}

impl LagTally {
    /// Adds the pairs of one block, given the fine cell of each draw.
    pub fn observe(&mut self, scores: &Scores, index: &[u32]) {
        let Self { products, pairs, ends, neighbours, buffer, groups } = self;
        buffer.clear();
        buffer.extend(index.iter().map(|&cell| scores.of(cell)));
        for (i, ((products, pairs), ends)) in products.iter_mut().zip(pairs).zip(ends).enumerate() {
            let later = buffer.get(i + 1..).unwrap_or_default();
            *products += i128::from(dot(buffer, later));
            *pairs += later.len() as u64;
            let first = buffer.len() - later.len();
            let at_ends = buffer[..first].iter().chain(&buffer[buffer.len() - first..]);
            *ends += at_ends.map(|&score| i128::from(score)).sum::<i128>();
        }
        count(scores, buffer, groups, neighbours);
    }

    /// The scores of the block that was observed last.
    pub(crate) fn last_scores(&self) -> &[i16] {
        &self.buffer
    }

    /// Adds the pairs of another worker.
    pub fn merge(&mut self, other: &Self) {
        for i in 0..LAGS {
            self.products[i] += other.products[i];
            self.pairs[i] += other.pairs[i];
            self.ends[i] += other.ends[i];
        }
        let theirs = other.neighbours.as_flattened();
        self.neighbours.as_flattened_mut().iter_mut().zip(theirs).for_each(|(a, b)| *a += b);
    }
}

/// The sum of products, as far as the shorter goes.
fn dot(a: &[i16], b: &[i16]) -> i64 {
    freepath_draws::simd::dispatch(
        #[inline(always)]
        || {
            let part = |(a, b): (&[i16], &[i16])| {
                let mut sum = 0;
                for (&a, &b) in a.iter().zip(b) {
                    sum += i32::from(a) * i32::from(b);
                }
                i64::from(sum)
            };
            a.chunks(PART).zip(b.chunks(PART)).map(part).sum()
        },
    )
}

/// Counts the pairs of neighbours: in tables that take turns, so that one count need not wait for another, and few enough
/// at a time for 32 bits.
fn count(
    scores: &Scores,
    buffer: &[i16],
    groups: &mut Vec<u8>,
    neighbours: &mut [[u64; RANK_GROUPS]; RANK_GROUPS],
) {
    scores.groups(buffer, groups);
    let mut tables = [[0u32; RANK_GROUPS * RANK_GROUPS]; TURNS];
    for pairs in groups.windows(TURNS + 1).step_by(TURNS) {
        for (table, pair) in tables.iter_mut().zip(pairs.windows(2)) {
            table[place(pair)] += 1;
        }
    }
    let counted = groups.len().saturating_sub(1) / TURNS * TURNS;
    groups[counted..].windows(2).for_each(|pair| tables[0][place(pair)] += 1);
    for (i, count) in neighbours.as_flattened_mut().iter_mut().enumerate() {
        *count += tables.iter().map(|table| u64::from(table[i])).sum::<u64>();
    }
}

/// The place where a pair of groups is counted. A group is less than [`RANK_GROUPS`], so that two fill a byte.
fn place(pair: &[u8]) -> usize {
    usize::from(pair[0] << 4 | pair[1])
}

#[cfg(test)]
mod tests;

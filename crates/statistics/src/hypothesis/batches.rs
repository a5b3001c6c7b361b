use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass};
use crate::special::pearson_two_sided;
use crate::tally::{DyadicSums, MEASURES, ScoreMoments, Sequence};
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "batches",
    words: "Sums over batches of neighbours scatter as sums of independent rows do: the variance of batch sums of ranks, and of how far \
each lies from the median, at every dyadic size over all rows.",
    details: "\
```text
z = (sum Y^2 - E) / sd,   E = m b s^2 (1 - (b - 1) / (n - 1)),   sd = s^2 sqrt(2 (m - 1) b (b - 1)),   b = 16, 32, .. while m >= 32
p = min(1, series x sizes x min of both tails)
```
Gate:    512 rows; a size counts where the skewness that the rows add to z is at most 0.05, and the kurtosis 1e-3.
Rejects: as dependent: copies, drifts and seeds by tile (too wide), or stratified and mirrored rows (too even); the note says at which size.
Source:  tail by Pearson's type III law (1895), which is chi-square for large batches.",
    nulls: &[NullClass::Conservative],
    alone: Alone::No,
    section: "batches",
};

/// Fewest batches of a size.
const FEWEST: u64 = 32;

/// The most that rows may add to the skewness of z.
const MOST_SKEW: f64 = 0.05;

/// The most by which the excess kurtosis that the rows add may be above that of the law of z.
const MOST_EXCESS: f64 = 1e-3;

/// The size whose variance is the least likely.
struct Extreme {
    p: f64,
    z: f64,
    ratio: f64,
    size: u64,
    of: &'static str,
}

/// Variances of sums over batches of every dyadic size.
///
/// ```text
/// z = (sum Y^2 - E) / sd,   skewness = sqrt(8 / (m - 1)) (b - 2) / sqrt(b (b - 1)) + c,   c = g^2 / sqrt(m b (b - 1) / 2)
/// ```
///
/// Y is a sum over b neighbours less its mean, g the skewness of the scores. Products within a batch do not correlate, so that the
/// fourth moment falls out, and the statistic is right from b = 16 on.
#[must_use]
pub fn batches(sequence: &Sequence) -> Evidence {
    let withheld =
        |why: &str| Evidence::withheld(TEST.name, f64::NAN, Reason::Dependent, why).under(Null::Conservative);
    let mut planned = 0;
    let mut least: Option<Extreme> = None;
    for ((batches, moments), of) in sequence.batches.iter().zip(&sequence.moments).zip(MEASURES) {
        for size in batches.sizes(FEWEST) {
            planned += 1;
            least = match (least, extreme(&size, moments, of)) {
                (Some(a), Some(b)) => Some(if b.p < a.p { b } else { a }),
                (a, b) => b.or(a),
            };
        }
    }
    if planned == 0 {
        return withheld("fewer than 32 batches of 16 rows");
    }
    let Some(Extreme { p, z, ratio, size, of }) = least else {
        return withheld("nearly all rows are alike: the tail of their sums is not known");
    };
    let p = if f64::from(planned) * p < 1.0 { f64::from(planned) * p } else { 1.0 };
    let note = format!("sums over {size} rows, {of}, scatter {ratio:.4} times as much as of independent rows");
    Evidence::new(TEST.name, z, None, p, Reason::Dependent).under(Null::Conservative).noted(note)
}

fn extreme(of: &DyadicSums, moments: &ScoreMoments, name: &'static str) -> Option<Extreme> {
    let (n, m, b, g) = (moments.rows as f64, of.batches as f64, of.size as f64, moments.skewness());
    let (variance, pairs) = (moments.spread() / n, b * (b - 1.0));
    let added = g * g / (0.5 * m * pairs).sqrt();
    let excess = moments.kurtosis() * moments.kurtosis() / (0.5 * m * pairs) - 1.5 * added * added;
    if !(variance > 0.0) || !(added <= MOST_SKEW) || !(excess <= MOST_EXCESS) {
        return None;
    }
    let expected = m * b * variance * (1.0 - (b - 1.0) / (n - 1.0));
    let sd = variance * (2.0 * (m - 1.0) * pairs).sqrt();
    let squares = centred(of, moments);
    let z = (squares - expected) / sd;
    let skewness = (8.0 / (m - 1.0)).sqrt() * (b - 2.0) / pairs.sqrt() + added;
    Some(Extreme { p: pearson_two_sided(skewness, z), z, ratio: squares / expected, size: of.size, of: name })
}

/// The sum of squares of batch sums less their expectation: in integers about the nearest whole mean, then about the mean.
fn centred(of: &DyadicSums, moments: &ScoreMoments) -> f64 {
    let (size, batches, mean) = (i128::from(of.size), i128::from(of.batches), moments.mean());
    let whole = mean.round();
    let middle = size * whole as i128;
    let squares = of.squares - 2 * middle * of.sum + batches * middle * middle;
    let offset = of.size as f64 * (mean - whole);
    squares as f64 - 2.0 * offset * (of.sum - batches * middle) as f64 + of.batches as f64 * offset * offset
}

#[cfg(test)]
mod tests {
    use super::super::sequence::planted::{drifting_blocks, right, sequence_of};
    use super::*;

    fn p(rows: &[f64]) -> f64 {
        batches(&sequence_of(rows)).p.unwrap_or(f64::NAN)
    }

    #[test]
    fn blocks_that_drift_copies_and_even_rows_are_seen() {
        let rows = right(1 << 17, 1);
        assert!(p(&rows) > 1e-3);
        assert!(p(&drifting_blocks(&rows, 1000, 0.05)) < 1e-6);
        assert!(p(&rows[..1 << 13].iter().flat_map(|&row| [row; 16]).collect::<Vec<_>>()) < 1e-100);
        let even: Vec<f64> = rows.iter().zip(0u32..).map(|(u, i)| (f64::from(i * 37 % 64) + u) / 64.0).collect();
        let evidence = batches(&sequence_of(&even));
        assert!(evidence.p < Some(1e-100) && evidence.statistic < 0.0, "{evidence:?}");
    }

    #[test]
    fn its_level_is_kept() {
        let below = (0..400).filter(|&seed| p(&right(3000, seed)) < 0.05).count();
        assert!(below < 45, "{below} of 400 below 0.05, where 20 are due"); // five standard deviations
    }

    #[test]
    fn few_rows_and_constants_are_not_examined() {
        assert_eq!([batches(&sequence_of(&right(500, 1))).p, batches(&sequence_of(&[1.0; 5000])).p], [None, None]);
    }
}

use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass};
use crate::special::{hypergeometric_two_sided, pearson_two_sided};
use crate::tally::{Prefix, ScoreMoments, Sequence};
use freepath_results::Reason;

/// The record of the test on ranks.
pub(super) const TEST: Test = Test {
    name: "along",
    words: "The first rows are like the rest: the sum of ranks, and of how far each lies from the median, over the first 256, 512, .. rows \
against all. It sees a warm-up, a bound that is learned, a stale start, a drift.",
    details: "\
```text
z = P_m / sqrt(s^2 m (n - m) / (n - 1)),   P_m = sum_(i <= m) (q_i - mean q),   m = 256, 512, .. n / 2
p = min(1, 2 prefixes x min of both tails)
```
Gate:    512 rows; a prefix counts where the skewness of z is at most 0.1, and its excess kurtosis 4e-3 above that of its law.
Rejects: as dependent; the note says where in the run the rows differ, and by how much.
Source:  the rank-sum test (Wilcoxon 1945), tail by Pearson's type III law (1895).",
    nulls: &[NullClass::Conservative],
    alone: Alone::No,
    section: "along-and-along_escapes",
};

/// The record of the test on escapes.
pub(super) const ESCAPES: Test = Test {
    name: "along_escapes",
    words: "As many of the first rows escape as of the rest: the escapes among the first 256, 512, .. rows against all, by the \
hypergeometric law.",
    details: "\
```text
p = min(1, prefixes x min_m 2 min(P(X <= k_m), P(X >= k_m))),   X the escapes among m of n rows, K of which escape
```
Gate:    512 rows.
Rejects: as dependent; the note says where in the run the share differs, and by how much.
Source:  Fisher's exact test (1935).",
    nulls: &[NullClass::Conservative],
    alone: Alone::Exact,
    section: "along-and-along_escapes",
};

/// The greatest skewness of a prefix for which its tail is known.
const MOST_SKEW: f64 = 0.1;

/// The most by which the excess kurtosis of a prefix may be above that of its Pearson law: 10 % of a tail of 5 standard deviations.
const MOST_EXCESS: f64 = 4e-3;

/// The prefix that is the least likely.
#[derive(Clone, Copy)]
struct Extreme {
    p: f64,
    statistic: f64,
    prefix: Prefix,
    series: usize,
}

/// The prefixes that are read: those of no more than half of the rows.
fn read(sequence: &Sequence) -> impl Iterator<Item = &Prefix> {
    let half = sequence.rows() / 2;
    sequence.prefixes.iter().take_while(move |prefix| prefix.rows <= half)
}

fn withheld(name: &str, why: &str) -> Evidence {
    Evidence::withheld(name, f64::NAN, Reason::Dependent, why).under(Null::Conservative)
}

/// Too few rows for a prefix.
const FEW: &str = "fewer than 512 rows";

/// Ranks of the first rows against all.
///
/// ```text
/// z = P_m / sqrt(s^2 m (n - m) / (n - 1)),   skewness g (n - 2 m) / sqrt(n m (n - m))
/// ```
#[must_use]
pub fn along(sequence: &Sequence) -> Evidence {
    let planned = 2 * read(sequence).count();
    if planned == 0 {
        return withheld(TEST.name, FEW);
    }
    let all = (0..2).flat_map(|series| read(sequence).filter_map(move |prefix| extreme(sequence, prefix, series)));
    let Some(Extreme { p, statistic, prefix, series }) = all.reduce(|a, b| if b.p < a.p { b } else { a }) else {
        return withheld(TEST.name, "nearly all rows are alike: the tail of their sums is not known");
    };
    let [first, rest] = means(&sequence.moments[series], &prefix, series);
    let what = ["the mean rank is", "the mean distance from the median rank is"][series];
    let note = format!("{what} {first:.4} in the first {} rows, {rest:.4} in the rest", prefix.rows);
    Evidence::new(TEST.name, statistic, None, times(planned, p), Reason::Dependent)
        .under(Null::Conservative)
        .noted(note)
}

fn times(planned: usize, p: f64) -> f64 {
    let p = planned as f64 * p;
    if p > 1.0 { 1.0 } else { p }
}

fn extreme(sequence: &Sequence, prefix: &Prefix, series: usize) -> Option<Extreme> {
    let moments = &sequence.moments[series];
    let (n, m, variance) = (moments.rows as f64, prefix.rows as f64, moments.spread() / moments.rows as f64);
    let skewness = moments.skewness() * (n - 2.0 * m) / (n * m * (n - m)).sqrt();
    let excess = (moments.kurtosis() - 3.0) / m - 1.5 * skewness * skewness;
    if !(variance > 0.0) || !(skewness.abs() <= MOST_SKEW) || !(excess <= MOST_EXCESS) {
        return None;
    }
    let (rows, of_all) = (i128::from(moments.rows), i128::from(moments.sum));
    let excess = rows * i128::from(prefix.sums[series]) - i128::from(prefix.rows) * of_all; // times n, in integers
    let statistic = excess as f64 / n / (variance * m * (n - m) / (n - 1.0)).sqrt();
    Some(Extreme { p: pearson_two_sided(skewness, statistic), statistic, prefix: *prefix, series })
}

/// Means in the prefix and in the rest, in units of rank.
fn means(moments: &ScoreMoments, prefix: &Prefix, series: usize) -> [f64; 2] {
    let rest = (moments.rows - prefix.rows) as f64;
    let sum = prefix.sums[series];
    let means = [sum as f64 / prefix.rows as f64, (moments.sum - sum) as f64 / rest];
    means.map(|mean| [0.5, 0.0][series] + mean / 4096.0)
}

/// Escapes among the first rows against all.
///
/// ```text
/// p = min(1, prefixes x min_m 2 min(P(X <= k_m), P(X >= k_m))),   X hypergeometric
/// ```
#[must_use]
pub fn along_escapes(sequence: &Sequence) -> Evidence {
    let (rows, escapes, planned) = (sequence.rows(), sequence.escapes, read(sequence).count());
    let of = |prefix: &Prefix| Extreme {
        p: hypergeometric_two_sided(prefix.escapes, prefix.rows, escapes, rows),
        statistic: prefix.escapes as f64,
        prefix: *prefix,
        series: 0,
    };
    let evidence = match read(sequence).map(of).reduce(|a, b| if b.p < a.p { b } else { a }) {
        None => withheld(ESCAPES.name, FEW),
        Some(Extreme { p, statistic, prefix, .. }) => {
            let due = escapes as f64 * prefix.rows as f64 / rows as f64;
            let note = format!("{statistic:.0} of the first {} rows escape, where {due:.1} are due", prefix.rows);
            Evidence::new(ESCAPES.name, statistic, None, times(planned, p), Reason::Dependent).noted(note)
        }
    };
    evidence.under(Null::Conservative).alone()
}

#[cfg(test)]
mod tests {
    use super::super::sequence::planted::{right, sequence_of};
    use super::*;

    fn stale(mut rows: Vec<f64>, first: usize) -> Vec<f64> {
        rows[..first].iter_mut().for_each(|row| *row *= 0.5);
        rows
    }

    #[test]
    fn a_stale_start_is_seen_and_placed() {
        let rows = right(100_000, 1);
        assert!(along(&sequence_of(&rows)).p > Some(1e-3));
        let seen = along(&sequence_of(&stale(rows, 512)));
        assert!(seen.p < Some(1e-20) && seen.note.contains("in the first 512 rows"), "{seen:?}");
    }

    #[test]
    fn escapes_of_a_warm_up_are_seen() {
        let escape = |u: f64| if u < 0.01 { f64::INFINITY } else { u };
        let mut rows: Vec<f64> = right(50_000, 2).into_iter().map(escape).collect();
        assert!(along_escapes(&sequence_of(&rows)).p > Some(1e-3));
        rows[..256].fill(f64::INFINITY);
        let seen = along_escapes(&sequence_of(&rows));
        assert!(seen.p < Some(1e-100) && seen.p_alone == seen.p);
        assert!(seen.note.starts_with("256 of the first 256 rows escape"), "{}", seen.note);
    }

    #[test]
    fn their_level_is_kept() {
        let escape = |u: f64| if u < 0.2 { f64::INFINITY } else { u };
        let rows = |seed| sequence_of(&right(3000, seed).into_iter().map(escape).collect::<Vec<_>>());
        let below = |p: fn(&Sequence) -> Evidence| (0..400).filter(|&seed| p(&rows(seed)).p < Some(0.05)).count();
        let counts = [below(along), below(along_escapes)];
        assert!(counts.iter().all(|&count| count < 45), "{counts:?} of 400 below 0.05, where 20 are due");
    }
}

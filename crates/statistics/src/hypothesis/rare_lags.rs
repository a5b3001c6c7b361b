use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass};
use crate::special::poisson_sf;
use crate::tally::Scored;
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "rare_lags",
    words: "Rare rows do not come back at a fixed distance: escapes or collisions, whichever are fewer, or the rows that differ from the \
commonest value, in pairs at each lag of the first rows.",
    details: "\
```text
lambda_k = (N - k) K (K - 1) / (N (N - 1)),   p = min(1, N / 2 min_k P(Poisson(lambda_k) >= pairs at lag k)),   k = 1 .. N / 2
```
Gate:    2048 rows, 2 to 1024 of them rare.
Rejects: as dependent: rows that are copied, where nearly all are alike and ranks say nothing.
Source:  the pairs at a lag are narrower than Poisson's law: too large a p-value.",
    nulls: &[NullClass::Conservative],
    alone: Alone::Measured,
    section: "rare_lags",
};

/// Rare rows that are looked at.
const EVENTS: std::ops::RangeInclusive<usize> = 2..=1024;

/// Pairs of rare rows at each lag.
///
/// ```text
/// p = min(1, N / 2 min_k P(Poisson(lambda_k) >= pairs at lag k)),   lambda_k = (N - k) K (K - 1) / (N (N - 1))
/// ```
#[must_use]
pub fn rare_lags(first: Option<&Scored>) -> Evidence {
    let withheld = |why: &str| Evidence::withheld(TEST.name, f64::NAN, Reason::Dependent, why);
    let evidence = match first {
        None => withheld(super::sequence::FEW),
        Some(first) if !EVENTS.contains(&first.events.len()) => withheld("not 2 to 1024 rows are rare"),
        Some(first) => judged(first.scores.len(), &first.events),
    };
    evidence.under(Null::Conservative).alone()
}

fn judged(rows: usize, events: &[u32]) -> Evidence {
    let (n, k) = (rows as f64, events.len() as f64);
    let density = k * (k - 1.0) / (n * (n - 1.0));
    let mut least = (1.0, 0, 0);
    for (pairs, lag) in furthest(rows / 2, events) {
        let p = poisson_sf((n - lag as f64) * density, pairs);
        least = if !(p >= least.0) { (p, pairs, lag) } else { least };
    }
    let (p, pairs, lag) = least;
    let p = if p * 0.5 * n < 1.0 { p * 0.5 * n } else { 1.0 };
    let note = format!("{} rare rows in {rows}: {pairs} pairs {lag} rows apart", events.len());
    Evidence::new(TEST.name, pairs as f64, None, p, Reason::Dependent).noted(note)
}

/// Of each number of pairs that a lag has, the greatest lag that has it: of equal numbers the least likely.
fn furthest(most: usize, events: &[u32]) -> Vec<(u64, usize)> {
    let mut pairs = vec![0u32; most + 1];
    for (i, first) in events.iter().enumerate() {
        let lags = events[i + 1..].iter().map(|later| (later - first) as usize);
        lags.take_while(|&lag| lag <= most).for_each(|lag| pairs[lag] += 1);
    }
    let mut greatest: Vec<(u64, usize)> = Vec::new();
    for (lag, &count) in pairs.iter().enumerate().filter(|(_, count)| **count > 0) {
        match greatest.iter_mut().find(|(of, _)| *of == u64::from(count)) {
            Some((_, furthest)) => *furthest = lag,
            None => greatest.push((u64::from(count), lag)),
        }
    }
    greatest
}

#[cfg(test)]
mod tests {
    use super::super::sequence::planted::{right, rows_of};
    use super::*;

    /// Rows that are 1 in a share of cases, else 0.
    fn rare(n: usize, share: f64, seed: u64) -> Vec<f64> {
        right(n, seed).into_iter().map(|u| f64::from(u8::from(u < share))).collect()
    }

    fn p(rows: &[f64]) -> Option<f64> {
        rare_lags(Some(&rows_of(rows, false))).p
    }

    #[test]
    fn copies_of_rare_rows_are_seen() {
        let rows = rare(1 << 17, 1e-3, 1);
        assert!(p(&rows) > Some(1e-3));
        let sixteen: Vec<f64> = rare(1 << 13, 1e-3, 2).into_iter().flat_map(|row| [row; 16]).collect();
        assert!(p(&sixteen) < Some(1e-30));
        assert!(p(&rare(1 << 13, 3e-3, 3).repeat(16)) < Some(1e-30));
    }

    #[test]
    fn too_few_and_too_many_are_not_examined() {
        assert_eq!([p(&rare(1 << 12, 0.5, 1)), p(&[0.0; 4096])], [None, None]);
    }

    #[test]
    fn its_level_is_kept() {
        let below = (0..400).filter(|&seed| p(&rare(1 << 12, 0.01, seed)) < Some(0.05)).count();
        assert!(below < 45, "{below} of 400 below 0.05, where 20 are due at most"); // five standard deviations
    }
}

use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass};
use crate::special::chi_square_sf;
use crate::tally::{RankGroups, Scored};
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "pairs_far",
    words: "Tables of rows that are 2 to 8, and 16, 32, .. rows apart, in 16 groups of rank among the first rows: the two are independent. \
It sees dependence at a distance that leaves no correlation.",
    details: "\
```text
X = sum (O_ab - n_a n_b / N)^2 / (n_a n_b / N),   dof = (k - 1)^2,   at lags d = 2 .. 8, 16, 32, .. N / 4
p = min(1, lags x min P(chi-square >= X))
```
Gate:    2048 rows; neighbouring groups are joined until each cell expects 50 pairs.
Rejects: as dependent: a number that is folded and used again some rows later. Reads the first 2^17 rows, or fewer (see the page).
Source:  as pairs_16; the rows are taken for a ring.",
    nulls: &[NullClass::Conservative],
    alone: Alone::No,
    section: "pairs_far-and-triples",
};

/// Groups of rank.
const GROUPS: usize = 16;

/// Pairs that each cell expects.
const EXPECTED: f64 = 50.0;

/// Tables of pairs of rows at some distance.
///
/// ```text
/// X = sum (O_ab - n_a n_b / N)^2 / (n_a n_b / N),   dof = (k - 1)^2,   p = min(1, lags x min)
/// ```
///
/// Not at N / 2, where a ring holds every pair twice.
#[must_use]
pub fn pairs_far(first: Option<&Scored>) -> Evidence {
    let withheld =
        |why: &str| Evidence::withheld(TEST.name, f64::NAN, Reason::Dependent, why).under(Null::Conservative);
    let Some(first) = first else { return withheld(super::sequence::FEW) };
    let n = first.scores.len();
    let groups = RankGroups::new(&first.scores, GROUPS, (EXPECTED * n as f64).sqrt());
    if groups.counts.len() < 2 {
        return withheld("fewer than two groups of rows are large enough for a table of pairs");
    }
    let dof = ((groups.counts.len() - 1) * (groups.counts.len() - 1)) as f64;
    let all: Vec<(f64, usize)> = lags(n).map(|lag| (statistic(&groups, lag), lag)).collect();
    let (x, lag) = all.iter().fold((0.0, 0), |most, &one| if one.0 > most.0 { one } else { most });
    let p = all.len() as f64 * chi_square_sf(dof, x);
    let (p, note) = (if p > 1.0 { 1.0 } else { p }, format!("most at lag {lag}"));
    Evidence::new(TEST.name, x, Some(dof), p, Reason::Dependent).under(Null::Conservative).noted(note)
}

/// 2 to 8, 16, 32, .. N / 4.
fn lags(n: usize) -> impl Iterator<Item = usize> {
    let powers = (4..).map(|power| 1usize << power).take_while(move |&lag| lag <= n / 4);
    (2..=8).chain(powers)
}

fn statistic(groups: &RankGroups, lag: usize) -> f64 {
    let n = groups.of.len() as f64;
    let products = groups.counts.iter().flat_map(|&a| groups.counts.iter().map(move |&b| a as f64 * b as f64));
    let terms = groups.pairs(lag).into_iter().zip(products).map(|(seen, product)| {
        let expected = product / n;
        (seen as f64 - expected) * (seen as f64 - expected) / expected
    });
    terms.sum()
}

#[cfg(test)]
mod tests {
    use super::super::sequence::planted::{right, rows_of};
    use super::*;

    fn evidence(rows: &[f64]) -> Evidence {
        pairs_far(Some(&rows_of(rows, false)))
    }

    #[test]
    fn a_fold_two_rows_later_is_seen() {
        let rows = right(1 << 15, 1);
        assert!(evidence(&rows).p > Some(1e-3));
        let tent = |u: f64| 1.0 - (2.0 * u - 1.0).abs();
        let folded: Vec<f64> = rows
            .chunks(2)
            .flat_map(|pair| [pair[0], pair[1], tent(pair[0]), tent(pair[1])])
            .take(1 << 15)
            .collect();
        let seen = evidence(&folded);
        assert!(seen.p < Some(1e-100) && seen.note == "most at lag 2", "{seen:?}");
    }

    #[test]
    fn its_level_is_kept_and_nearly_constant_rows_are_not_examined() {
        let below = (0..400).filter(|&seed| evidence(&right(1 << 12, seed)).p < Some(0.05)).count();
        assert!(below < 45, "{below} of 400 below 0.05, where 20 are due"); // five standard deviations
        let mut rare = vec![0.0; 4096];
        rare[17] = 1.0;
        assert_eq!(evidence(&rare).p, None);
    }
}

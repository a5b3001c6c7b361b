use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass};
use crate::special::chi_square_sf;
use crate::tally::{RankGroups, Scored};
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "triples",
    words: "A table of three rows in a row, in 8 groups of rank among the first rows: given the middle one, the outer two are independent. It \
sees what no pair shows, such as a third number made of two.",
    details: "\
```text
X = sum (O_abc - O_ab. O_.bc / O_.b.)^2 / (O_ab. O_.bc / O_.b.),   dof = k (k - 1)^2
```
Gate:    2048 rows; neighbouring groups are joined until each cell expects 20 triples.
Rejects: as dependent: exclusive-or or sums of the two draws before, lattices of poor generators.
Source:  second order against first order of a chain (Bartlett 1951; Good 1955): overlapping triples keep the chi-square law.",
    nulls: &[NullClass::Uniform],
    alone: Alone::No,
    section: "pairs_far-and-triples",
};

/// Groups of rank.
const GROUPS: usize = 8;

/// Triples that each cell expects.
const EXPECTED: f64 = 20.0;

/// A table of triples against its own pairs.
///
/// ```text
/// X = sum (O_abc - O_ab. O_.bc / O_.b.)^2 / (O_ab. O_.bc / O_.b.),   dof = k (k - 1)^2
/// ```
#[must_use]
pub fn triples(first: Option<&Scored>) -> Evidence {
    let withheld = |why: &str| Evidence::withheld(TEST.name, f64::NAN, Reason::Dependent, why);
    let Some(first) = first else { return withheld(super::sequence::FEW).under(Null::Uniform) };
    let n = first.scores.len() as f64;
    let groups = RankGroups::new(&first.scores, GROUPS, libm::cbrt(EXPECTED * n * n));
    let k = groups.counts.len();
    if k < 2 {
        return withheld("fewer than two groups of rows are large enough for a table of triples");
    }
    let (pairs, triples) = (groups.pairs(1), groups.triples());
    let mut x = 0.0;
    for (i, &seen) in triples.iter().enumerate() {
        let (ab, bc) = (i / k, i % (k * k));
        let expected = pairs[ab] as f64 * pairs[bc] as f64 / groups.counts[ab % k] as f64;
        let off = seen as f64 - expected;
        x += if expected > 0.0 { off * off / expected } else { 0.0 }; // pairs that never come make no triple
    }
    let dof = (k * (k - 1) * (k - 1)) as f64;
    Evidence::new(TEST.name, x, Some(dof), chi_square_sf(dof, x), Reason::Dependent)
}

#[cfg(test)]
mod tests {
    use super::super::sequence::planted::{right, rows_of};
    use super::*;

    fn evidence(rows: &[f64]) -> Evidence {
        triples(Some(&rows_of(rows, false)))
    }

    #[test]
    fn a_third_row_made_of_two_is_seen() {
        let rows = right(1 << 15, 1);
        assert!(evidence(&rows).p > Some(1e-3));
        let sum = |pair: &[f64]| [pair[0], pair[1], (pair[0] + pair[1]) % 1.0];
        let made: Vec<f64> = rows.chunks_exact(2).flat_map(sum).take(1 << 15).collect();
        assert!(evidence(&made).p < Some(1e-100));
    }

    #[test]
    fn its_level_is_kept_and_nearly_constant_rows_are_not_examined() {
        let below = (0..400).filter(|&seed| evidence(&right(1 << 12, seed)).p < Some(0.05)).count();
        assert!(below < 45, "{below} of 400 below 0.05, where 20 are due"); // five standard deviations
        assert_eq!(evidence(&vec![0.0; 4096]).p, None);
    }
}

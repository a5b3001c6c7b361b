use super::grouped;
use super::record::Test;
use crate::evidence::{Alone, Evidence, NullClass};
use crate::law::Law;
use crate::special::anderson_darling_sf;
use crate::tally::CellTally;
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "anderson_darling",
    words: "The squared gap between the empirical and the analytic CDF of the collided draws, weighed by its inverse \
variance and integrated (Anderson and Darling 1952). Shown only: it spends no error.",
    details: "\
```text
A^2 = m int (F_m - u)^2 / (u (1 - u)) du,   u = F(t) / F(length)
```
Gate:    1000 collisions, at most 1/1024 of them in a fine cell, a law known to 0.01 standard deviations.
Rejects: nothing; shown beside the others. Weighs both ends of the ray.
Source:  Anderson and Darling (1952); p over its full range by Smirnov (1937).",
    nulls: &[NullClass::Uniform],
    alone: Alone::No,
    section: "anderson_darling",
};

/// Anderson-Darling on u = F(t) / F(length) of the collided draws, over the fine cells: reported, not judged.
///
/// ```text
/// A^2 = m int (F_m - u)^2 / (u (1 - u)) du
/// ```
///
/// Within a cell F_m is not known: the gap is taken as the line between the edges, and the bridge around it at its expectation,
/// so A^2 keeps its mean. What is lost is the bridge's scatter (1e-3 of A^2), and the sight of what happens within a cell: a defect
/// narrower than the first cell weighs as if it were spread over it. Withheld below 1000 collisions, or where a cell holds
/// more than 1/1024 of them.
///
/// Cost: three divisions a cell.
#[must_use]
pub fn anderson_darling(law: &Law, tally: &CellTally, reason: Reason) -> Evidence {
    let m = tally.collided();
    if let Some(why) = grouped::gate(law, m) {
        return Evidence::withheld(TEST.name, f64::NAN, reason, why).reported();
    }
    let weight = |u: f64, rest: f64| 1.0 / (u * rest);
    let cells = grouped::cells(law, tally, m).filter(|cell| !(cell.share <= 0.0));
    let square: f64 = cells.map(|cell| cell.square(m as f64, weight)).sum();
    Evidence::new(TEST.name, square, None, anderson_darling_sf(square), reason).reported()
}

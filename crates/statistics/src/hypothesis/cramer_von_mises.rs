use super::grouped;
use super::record::Test;
use crate::evidence::{Alone, Evidence, NullClass};
use crate::law::Law;
use crate::special::cramer_von_mises_sf;
use crate::tally::CellTally;
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "cramer_von_mises",
    words: "The squared gap between the empirical and the analytic CDF of the collided draws, integrated \
(Cramer 1928, von Mises 1931). Shown only: it spends no error.",
    details: "\
```text
W^2 = m int (F_m - u)^2 du,   u = F(t) / F(length)
```
Gate:    1000 collisions, at most 1/1024 of them in a fine cell, a law known to 0.01 standard deviations.
Rejects: nothing; shown beside the others.
Source:  Cramer (1928), von Mises (1931); p by Smirnov (1937), Csorgo and Faraway (1996).",
    nulls: &[NullClass::Uniform],
    alone: Alone::No,
    section: "cramer_von_mises",
};

/// Cramer-von Mises on u = F(t) / F(length) of the collided draws, over the fine cells: reported, not judged.
///
/// ```text
/// W^2 = m int (F_m - u)^2 du
/// ```
///
/// Within a cell F_m is not known: the gap is taken as the line between the edges, and the bridge around it at its expectation,
/// so W^2 keeps its mean; what is lost is the bridge's scatter, below 1e-3 of W^2. Withheld below 1000 collisions, or where a
/// cell holds more than 1/1024 of them.
#[must_use]
pub fn cramer_von_mises(law: &Law, tally: &CellTally, reason: Reason) -> Evidence {
    let m = tally.collided();
    if let Some(why) = grouped::gate(law, m) {
        return Evidence::withheld(TEST.name, f64::NAN, reason, why).reported();
    }
    let square: f64 = grouped::cells(law, tally, m).map(|cell| cell.square(m as f64, |_, _| 1.0)).sum();
    Evidence::new(TEST.name, square, None, cramer_von_mises_sf(m, square), reason).reported()
}

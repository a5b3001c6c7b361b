use super::grouped;
use super::record::Test;
use crate::evidence::{Alone, Evidence, NullClass};
use crate::larger::larger;
use crate::law::Law;
use crate::special::kuiper_sf;
use crate::tally::CellTally;
use freepath_results::Reason;

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "kuiper",
    words: "The largest gap by which the empirical CDF of the collided draws lies above the analytic one, plus the \
largest below (Kuiper 1960). Shown only: it spends no error.",
    details: "\
```text
V = sup (F_m - u) + sup (u - F_m),   p = Q((sqrt m + 0.155 + 0.24 / sqrt m) V)
```
Gate:    1000 collisions, at most 1/1024 of them in a fine cell, a law known to 0.01 standard deviations.
Rejects: nothing; shown beside the others. Sees a shift in the middle that ends cancel in `kolmogorov`.
Source:  Kuiper (1960), Stephens (1970).",
    nulls: &[NullClass::Uniform],
    alone: Alone::No,
    section: "kuiper",
};

/// Kuiper's statistic on u = F(t) / F(length) of the collided draws, over the edges of the fine cells: reported, not judged.
///
/// ```text
/// V = D+ + D-,   each the largest gap at an edge and 0.5826 sqrt(c) / m sqrt(c / (c + 1.36)), c = m share of the cell there
/// ```
///
/// The edges miss how far a gap goes on within a cell: for cells of many draws by 0.5826 standard deviations of its count on average
/// (Broadie, Glasserman and Kou 1997: -zeta(1/2) / sqrt(2 pi)), for few by half a cell; the term above joins the two.
/// Without it p would be some 5 % too large for cells of 6e-5, 20 % for 5e-4. Withheld below 1000 collisions, or where a cell
/// holds more than 1/1024 of them.
#[must_use]
pub fn kuiper(law: &Law, tally: &CellTally, reason: Reason) -> Evidence {
    let m = tally.collided();
    if let Some(why) = grouped::gate(law, m) {
        return Evidence::withheld(TEST.name, f64::NAN, reason, why).reported();
    }
    let hidden = |share: f64| {
        let count = m as f64 * share;
        0.582_597_157 * count / ((count + 1.36).sqrt() * m as f64)
    };
    let (mut above, mut below) = (0.0, 0.0);
    for cell in grouped::cells(law, tally, m) {
        above = larger(above, cell.end.gap + hidden(cell.share));
        below = larger(below, hidden(cell.share) - cell.start.gap);
    }
    let v = above + below;
    let p = if v.is_nan() { f64::NAN } else { kuiper_sf(m, v) };
    Evidence::new(TEST.name, v, None, p, reason).reported()
}

use super::series::band;
use crate::detection::Detection;
use crate::evidence::REPORTING_LEVEL;
use crate::hypothesis::{Among, detectable_cell, detectable_scale, sup_distance};
use crate::larger::larger;
use crate::law::Law;
use crate::special::clopper_pearson;
use crate::tally::CellTally;
use freepath_results::{Atom, LawResult, Real};

/// The distance of a column from a law, and the distance that would have been seen.
pub(in crate::claim) fn law_result(law: &Law, tally: &CellTally, detection: &Detection) -> LawResult {
    let n = tally.draws();
    let distance = sup_distance(law, tally, Among::All);
    LawResult {
        distance: Real(distance.low),
        bound: Real(distance.high + band(n)),
        detectable: Real(detection.distance() + hidden(law) + law.slack()),
        detectable_scale: detectable_scale(law, n, detection).map(Real),
        detectable_cell: detectable_cell(law, tally, detection).map(Real),
        atom: atom(law, tally),
        grown: None,
    }
}

/// The most that a distance may be above what is seen at the edges of the cells.
fn hidden(law: &Law) -> f64 {
    if law.is_of_counts() {
        return 0.0;
    }
    (0..law.cells()).map(|k| law.mass(k)).fold(0.0, larger)
}

fn atom(law: &Law, tally: &CellTally) -> Atom {
    let n = tally.draws();
    let (low, high) = clopper_pearson(n, tally.escapes, REPORTING_LEVEL);
    Atom {
        expected: Real(law.atom()),
        estimate: Real(tally.escapes as f64 / n as f64),
        low: Real(low),
        high: Real(high),
    }
}

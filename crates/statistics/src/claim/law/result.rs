use super::series::band;
use crate::evidence::{POWER, REPORTING_LEVEL};
use crate::hypothesis::{Among, detectable_cell, detectable_scale, sup_distance};
use crate::law::Law;
use crate::special::{clopper_pearson, normal_quantile};
use crate::tally::CellTally;
use freepath_results::{Atom, LawResult, Real};

/// The distance of a column from a law, and the distance that would have been seen.
pub(in crate::claim) fn law_result(law: &Law, tally: &CellTally) -> LawResult {
    let n = tally.draws();
    let distance = sup_distance(law, tally, Among::All);
    let power = normal_quantile(1.0 - POWER) / (2.0 * (n as f64).sqrt());
    LawResult {
        distance: Real(distance.low),
        bound: Real(distance.high + band(n)),
        detectable: Real(band(n) + power),
        detectable_scale: detectable_scale(law, n, REPORTING_LEVEL).map(Real),
        detectable_cell: detectable_cell(law, tally, REPORTING_LEVEL).map(Real),
        atom: atom(law, tally),
        grown: None,
    }
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

use super::{COLUMNS, pdf};
use crate::experiment::{Plan, Terms};
use crate::kind::two_ranks::TwoRanks;
use crate::kind::{Source, Table2d};
use freepath_estimators::table_2d::{Grid, Place};
use freepath_statistics::claim::PdfIntegral;
use freepath_statistics::{Grain, Law};
use std::sync::Arc;

/// Of 1, so many ulp may be lost where weights are summed up.
const ULPS: f64 = 4.0;

/// Places lie in cells with mass, their two ranks are uniform on the square, and the density that a sampler tells integrates to 1.
pub(super) fn plan<'a>(grid: &'a Arc<Grid>, source: &Source<'a, Table2d>, terms: &Terms) -> Plan<'a> {
    let step = libm::ldexp(1.0, -(terms.bits as i32));
    let grain = Grain::of_ranks(terms.bits, grid.steepness() * step);
    let slack = terms.tolerance + ULPS * f64::EPSILON;
    let law = Arc::new(Law::new(1.0, slack, |rank| 1.0 - rank).grained(grain));
    let (within, ranked) = (grid.clone(), grid.clone());
    let pdf =
        source.sampler().map(|sampler| PdfIntegral { mass: pdf::mass(sampler, grid), over: "the rectangle" });
    let ranks = TwoRanks {
        columns: COLUMNS,
        inside: Arc::new(move |row| place(row).is_some_and(|at| within.holds(at))),
        ranks: Arc::new(move |row| ranked.ranks(place(row).filter(|at| ranked.holds(*at))?)),
        law,
        pdf,
    };
    ranks.plan(source.is_external(), terms)
}

fn place(row: &[f64]) -> Option<Place> {
    <[f64; 2]>::try_from(row).ok().map(|[x, y]| Place { x, y })
}

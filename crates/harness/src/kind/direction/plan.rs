use super::{COLUMNS, pdf};
use crate::experiment::{Plan, Terms};
use crate::kind::two_ranks::{RanksOf, TwoRanks};
use crate::kind::{Direction, Source};
use freepath_estimators::direction::Directions;
use freepath_statistics::claim::PdfIntegral;
use freepath_statistics::fold::Inside;
use freepath_statistics::{Grain, Law};
use std::sync::Arc;

/// Directions are unit vectors of the support, their two ranks are uniform on the square, and the density that a sampler tells of any
/// direction integrates to 1.
pub(super) fn plan<'a>(truth: &'a Arc<Directions>, source: &Source<'a, Direction>, terms: &Terms) -> Plan<'a> {
    let grain = Grain::of_ranks(terms.bits, truth.slack(libm::ldexp(1.0, -(terms.bits as i32))));
    let law = Arc::new(Law::new(1.0, truth.slack(terms.tolerance), |rank| 1.0 - rank).grained(grain));
    let inside = inside(truth, terms.tolerance);
    let ranks = ranks(truth, &inside);
    let sampler = source.sampler();
    let pdf = sampler.map(|sampler| PdfIntegral { mass: pdf::mass(sampler, truth), over: "the sphere" });
    TwoRanks { columns: COLUMNS, inside, ranks, law, pdf }.plan(source.is_external(), terms)
}

/// A predicate: true where a direction may lie.
fn inside(truth: &Arc<Directions>, tolerance: f64) -> Inside {
    let truth = truth.clone();
    Arc::new(move |w| <[f64; 3]>::try_from(w).is_ok_and(|w| truth.holds(w, tolerance)))
}

/// Angle and azimuth of a direction as ranks.
fn ranks(truth: &Arc<Directions>, inside: &Inside) -> RanksOf {
    let (truth, inside) = (truth.clone(), inside.clone());
    Arc::new(move |w| {
        let ranks = truth.ranks(<[f64; 3]>::try_from(w).ok().filter(|w| inside(w))?);
        Some([ranks.angle, ranks.azimuth])
    })
}

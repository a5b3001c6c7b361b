use super::{COLUMNS, pdf};
use crate::experiment::{Plan, Terms};
use crate::kind::{Direction, Source, batches};
use freepath_estimators::direction::{Directions, Ranks};
use freepath_results::Reason;
use freepath_statistics::claim::{
    Claims, Domain, EnoughRows, Evenness, JointRanks, LawAgreement, LawClaim, ObservedOrder, Order, PdfIntegral,
    SecondRank, Withdrawal, joint_rank,
};
use freepath_statistics::fold::{Cells, FoldId, Inside, Lags, Places, Rank, RankOf, Values};
use freepath_statistics::tally::Scores;
use freepath_statistics::{CellIndex, Grain, Law};
use std::sync::Arc;

/// Directions are unit vectors of the support, their two ranks are uniform on the square, and the density that a sampler tells of any
/// direction integrates to 1.
pub(super) fn plan<'a>(truth: &'a Arc<Directions>, source: &Source<'a, Direction>, terms: &Terms) -> Plan<'a> {
    let (mut claims, reason) = (Claims::default(), Reason::WrongLaw);
    let grain = Grain::of_ranks(terms.bits, truth.slack(libm::ldexp(1.0, -(terms.bits as i32))));
    let law = Arc::new(Law::new(1.0, truth.slack(terms.tolerance), |rank| 1.0 - rank).grained(grain));
    let inside = inside(truth, terms.tolerance);
    let ranked = |of, claims: &mut Claims| Ranked::add(&law, rank(truth, &inside, of), claims);
    let places = Places { columns: COLUMNS, inside: inside.clone(), atoms: Vec::new() };
    let places = claims.folds.add(places);
    claims.push(Domain { columns: COLUMNS, inside: inside.clone(), places });
    if source.is_external() {
        claims.push(EnoughRows);
    }
    let angle = ranked(|ranks| ranks.angle, &mut claims);
    let azimuth = ranked(|ranks| ranks.azimuth, &mut claims);
    let joint = ranked(|ranks| joint_rank(ranks.angle, ranks.azimuth), &mut claims);
    claims.push(LawAgreement { cells: angle.cells, reason });
    claims.push(follows(&law, &angle));
    claims.push(SecondRank(LawClaim { grows: false, ..follows(&law, &azimuth) }));
    let first = batches::shares(&law, angle.index, reason, terms, &mut claims);
    batches::push(first, &mut claims);
    let second = batches::shares(&law, azimuth.index, reason, terms, &mut claims);
    batches::push(second.map(SecondRank), &mut claims);
    let words = "the two ranks of a draw are uniform on the square";
    claims.push(JointRanks { law: law.clone(), cells: joint.cells, reason, words });
    if let Some(sampler) = source.sampler() {
        claims.push(PdfIntegral { mass: pdf::mass(sampler, truth), over: "the sphere" });
    }
    let (first, second) = (angle.cells, azimuth.cells);
    order(&law, [angle, azimuth], source, terms, &mut claims);
    let even = |prefix, cells| Evenness { prefix, law: law.clone(), cells };
    claims.push(even("", first));
    claims.push(SecondRank(even("", second)));
    claims.push(even("joint_", joint.cells));
    Plan { claims, beside: Vec::new() }
}

/// A rank is uniform.
fn follows(law: &Arc<Law>, rank: &Ranked) -> LawClaim {
    LawClaim {
        law: law.clone(),
        cells: rank.cells,
        reason: Reason::WrongLaw,
        own: None,
        breaks: Vec::new(),
        order: None,
        grows: true,
        distances: false,
    }
}

/// Neighbours in drawing order, in both ranks.
fn order(law: &Law, ranks: [Ranked; 2], source: &Source<Direction>, terms: &Terms, claims: &mut Claims) {
    if !terms.stands(Withdrawal::Independent) {
        return;
    }
    let (scores, rows) = (Arc::new(Scores::new(law)), terms.ordered_rows(source.is_external()));
    let [first, second] = ranks.map(|Ranked { cells, index }| {
        let lags = claims.folds.add(Lags { scores: scores.clone(), index, rows });
        Order { scores: scores.clone(), lags, cells }
    });
    if terms.stands(Withdrawal::Truth) {
        claims.push(first);
        claims.push(SecondRank(second));
    } else {
        claims.push(observed(first));
        claims.push(SecondRank(observed(second)));
    }
}

/// The same where the law is not claimed.
fn observed(Order { scores, lags, cells }: Order) -> ObservedOrder {
    ObservedOrder { scores, lags, cells }
}

/// A rank by cell of the uniform law.
struct Ranked {
    cells: FoldId<Cells>,
    index: CellIndex,
}

impl Ranked {
    fn add(law: &Arc<Law>, of: RankOf, claims: &mut Claims) -> Self {
        let index = claims.folds.cell_index();
        let values = Values::Rank(Rank { columns: COLUMNS, of });
        Self { cells: claims.folds.add(Cells { values, law: law.clone(), index }), index }
    }
}

/// A predicate: true where a direction may lie.
fn inside(truth: &Arc<Directions>, tolerance: f64) -> Inside {
    let truth = truth.clone();
    Arc::new(move |w| <[f64; 3]>::try_from(w).is_ok_and(|w| truth.holds(w, tolerance)))
}

/// A rank of a direction; -1 where there is no mass.
fn rank(truth: &Arc<Directions>, inside: &Inside, of: fn(Ranks) -> f64) -> RankOf {
    let (truth, inside) = (truth.clone(), inside.clone());
    Arc::new(move |w| {
        if w.iter().any(|x| x.is_nan()) {
            f64::NAN
        } else if inside(w) {
            let rank = <[f64; 3]>::try_from(w).map_or(f64::NAN, |w| of(truth.ranks(w)));
            if rank > 1.0 { 1.0 } else { rank } // at the rim, by rounding
        } else {
            -1.0
        }
    })
}

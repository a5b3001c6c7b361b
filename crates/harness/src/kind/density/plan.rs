use crate::experiment::{Plan, Terms};
use crate::kind::batches;
use freepath_estimators::density::{Target, X};
use freepath_results::Reason;
use freepath_statistics::claim::{
    AtomsClaim, Claims, Domain, EnoughRows, Evenness, LawAgreement, LawClaim, ObservedOrder, Order, Withdrawal,
};
use freepath_statistics::fold::{Cells, FoldId, Inside, Lags, Places, Rank, RankOf, Values};
use freepath_statistics::tally::Scores;
use freepath_statistics::{Grain, Law};
use std::sync::Arc;

/// Numbers lie where there is mass, and their ranks are uniform but for the atoms.
pub(super) fn plan<'a>(target: &'a Arc<Target>, external: bool, terms: &Terms) -> Plan<'a> {
    let (mut claims, reason) = (Claims::default(), Reason::WrongLaw);
    let (law, index) = (Arc::new(ranks(target, terms)), claims.folds.cell_index());
    let values = Values::Rank(Rank { columns: &[X], of: rank(target.clone()) });
    let cells = claims.folds.add(Cells { values, law: law.clone(), index });
    let inside: Inside = Arc::new({
        let target = target.clone();
        move |row| row.iter().all(|&x| target.has_mass(x))
    });
    let atoms = target.atoms().iter().map(|atom| atom.at).collect();
    let places = claims.folds.add(Places { columns: &[X], inside: inside.clone(), atoms });
    claims.push(Domain { columns: &[X], inside, places });
    if external {
        claims.push(EnoughRows);
    }
    claims.push(LawAgreement { cells, reason });
    claims.push(LawClaim {
        law: law.clone(),
        cells,
        reason,
        own: None,
        breaks: Vec::new(),
        order: None,
        grows: true,
        distances: false,
    });
    let shares = batches::shares(&law, index, reason, terms, &mut claims);
    batches::push(shares, &mut claims);
    if target.atoms().len() > 1 {
        let masses = target.atoms().iter().map(|atom| atom.mass).collect();
        claims.push(AtomsClaim { masses, slack: law.slack(), places });
    }
    let rows = terms.ordered_rows(external);
    order(&law, |scores| Lags { scores, index, rows }, cells, terms, &mut claims);
    Plan { claims, beside: Vec::new() }
}

/// Rows in drawing order, and counts that are as uneven as independent ones are.
fn order(
    law: &Arc<Law>,
    lags: impl FnOnce(Arc<Scores>) -> Lags,
    cells: FoldId<Cells>,
    terms: &Terms,
    claims: &mut Claims,
) {
    if !terms.stands(Withdrawal::Independent) {
        return;
    }
    let scores = Arc::new(Scores::new(law));
    let lags = claims.folds.add(lags(scores.clone()));
    if terms.stands(Withdrawal::Truth) {
        claims.push(Order { scores, lags, cells });
        claims.push(Evenness { prefix: "", law: law.clone(), cells });
    } else {
        claims.push(ObservedOrder { scores, lags, cells });
    }
}

/// The law of the ranks: uniform on [0, 1) for the continuous part, at infinity for an atom.
fn ranks(target: &Target, terms: &Terms) -> Law {
    let share = 1.0 - target.atom_mass();
    let survival = move |rank: f64| if rank < 1.0 { 1.0 - share * rank } else { 1.0 - share };
    let rounding = target.steepness() * libm::ldexp(1.0, -(terms.bits as i32));
    Law::new(1.0, terms.tolerance + target.error(), survival).grained(Grain::of_ranks(terms.bits, rounding))
}

/// The share of the continuous part at or below a number; infinity for an atom, -1 for a number without mass.
fn rank(target: Arc<Target>) -> RankOf {
    let share = 1.0 - target.atom_mass();
    Arc::new(move |row| {
        let x = row[0];
        let is_atom = target.atoms().iter().any(|atom| x.total_cmp(&atom.at).is_eq());
        if x.is_nan() {
            f64::NAN
        } else if is_atom {
            f64::INFINITY
        } else if target.holds(x) {
            target.continuous_mass(x) / share
        } else {
            -1.0
        }
    })
}

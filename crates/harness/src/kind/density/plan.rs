use crate::experiment::{Plan, Terms};
use crate::kind::batches;
use freepath_estimators::density::{TRIALS, Target, X, geometric};
use freepath_results::Reason;
use freepath_statistics::claim::{
    AtomsClaim, Claims, Domain, EnoughRows, Evenness, JointRanks, LawAgreement, LawClaim, ObservedOrder, Order,
    Trials, Withdrawal,
};
use freepath_statistics::fold::{Cells, FoldId, Inside, Lags, Places, Rank, RankOf, Values};
use freepath_statistics::tally::Scores;
use freepath_statistics::{Grain, Law};
use std::sync::Arc;

/// The columns of a sampler: the number, and where they are counted its trials.
const COLUMNS: &[&str; 2] = &[X, TRIALS];

/// Numbers lie where there is mass, and their ranks are uniform but for the atoms.
pub(super) fn plan<'a>(target: &'a Arc<Target>, external: bool, trials: Option<f64>, terms: &Terms) -> Plan<'a> {
    let (mut claims, reason) = (Claims::default(), Reason::WrongLaw);
    let (law, index) = (Arc::new(ranks(target, terms)), claims.folds.cell_index());
    let values = Values::Rank(Rank { columns: &[X], of: rank(target.clone()) });
    let cells = claims.folds.add(Cells { values, law: law.clone(), index });
    let columns: &[&str] = if trials.is_some() { COLUMNS } else { &COLUMNS[..1] };
    let inside: Inside = Arc::new({
        let target = target.clone();
        move |row| target.has_mass(row[0]) && row[1..].iter().all(|&trials| is_count(trials))
    });
    let atoms = target.atoms().iter().map(|atom| atom.at).collect();
    let places = claims.folds.add(Places { columns, inside: inside.clone(), atoms });
    claims.push(Domain { columns, inside, places });
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
    if let Some(mean) = trials {
        counted(target, mean, terms, &mut claims);
    }
    let rows = terms.ordered_rows(external);
    order(&law, |scores| Lags { scores, index, rows }, cells, terms, &mut claims);
    Plan { claims, beside: Vec::new() }
}

/// Trials follow their law, whatever the number that they led to.
fn counted(target: &Arc<Target>, mean: f64, terms: &Terms, claims: &mut Claims) {
    let (masses, slack) = (geometric(mean), terms.tolerance + target.error());
    let last = masses.len() - 1;
    let class = move |trials: f64| if trials < last as f64 { trials as usize } else { last };
    let law = Arc::new(Law::of_counts(&masses, slack));
    let of: RankOf = Arc::new(move |row| if is_count(row[0]) { class(row[0]) as f64 + 0.5 } else { -1.0 });
    let index = claims.folds.cell_index();
    let values = Values::Rank(Rank { columns: &COLUMNS[1..], of });
    let cells = claims.folds.add(Cells { values, law, index });
    let below: Vec<f64> = masses.iter().scan(0.0, |sum, mass| Some(std::mem::replace(sum, *sum + mass))).collect();
    let (of, joint) = (rank(target.clone()), masses.clone());
    let both: RankOf = Arc::new(move |row| {
        let (rank, trials) = (of(&row[..1]), row[1]);
        if is_count(trials) { below[class(trials)] + joint[class(trials)] * rank } else { -1.0 }
    });
    let law = Arc::new(ranks(target, terms));
    let index = claims.folds.cell_index();
    let values = Values::Rank(Rank { columns: COLUMNS, of: both });
    let joint = claims.folds.add(Cells { values, law: law.clone(), index });
    claims.push(Trials { cells, masses, mean, slack: 2.0 * slack });
    let words = "a number and its trials are independent, and give back a uniform number together";
    claims.push(JointRanks { law, cells: joint, reason: Reason::WrongLaw, words });
}

/// True of a number of trials.
fn is_count(trials: f64) -> bool {
    trials >= 1.0 && trials.fract() == 0.0
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

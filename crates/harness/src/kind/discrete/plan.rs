use crate::experiment::{Plan, Terms};
use crate::kind::batches;
use crate::kind::column_order::OrderedColumn;
use freepath_estimators::discrete::{Categories, INDEX, REMAPPED};
use freepath_results::Reason;
use freepath_statistics::claim::{
    Claims, CountLaw, Domain, EnoughRows, Evenness, JointRanks, LawAgreement, LawClaim, Order, SecondRank,
    Withdrawal,
};
use freepath_statistics::fold::{Cells, FoldId, Inside, Lags, Places, Rank, RankOf, Values};
use freepath_statistics::tally::Scores;
use freepath_statistics::{CellIndex, Grain, Law};
use std::sync::Arc;

/// The columns of a sampler: the category, and what is left of its uniform.
const COLUMNS: &[&str; 2] = &[INDEX, REMAPPED];
/// Of 1, so many ulp may be lost where probabilities are summed up.
const ULPS: f64 = 4.0;

/// Categories that have a weight are drawn as often as it says; what is left of the uniform of each is uniform, whatever the category.
pub(super) fn plan<'a>(categories: &'a Arc<Categories>, external: bool, terms: &Terms) -> Plan<'a> {
    let mut claims = Claims::default();
    let columns: &[&str] = if external { &COLUMNS[..1] } else { COLUMNS };
    let inside = inside(categories);
    let places = claims.folds.add(Places { columns, inside: inside.clone(), atoms: Vec::new() });
    claims.push(Domain { columns, inside, places });
    if external {
        claims.push(EnoughRows);
    }
    let counted = counted(categories, terms, &mut claims);
    even(&counted, "", &mut claims);
    OrderedColumn::only(INDEX).claim(external, terms, &mut claims);
    if !external {
        remapped(categories, terms, &mut claims);
    }
    Plan { claims, beside: Vec::new() }
}

/// A law, and the rows by its cells.
struct Counted {
    law: Arc<Law>,
    cells: FoldId<Cells>,
    index: CellIndex,
}

impl Counted {
    fn add(law: Law, columns: &'static [&'static str], of: RankOf, claims: &mut Claims) -> Self {
        let (law, index) = (Arc::new(law), claims.folds.cell_index());
        let values = Values::Rank(Rank { columns, of });
        Self { cells: claims.folds.add(Cells { values, law: law.clone(), index }), law, index }
    }

    fn follows(&self) -> LawClaim {
        LawClaim {
            law: self.law.clone(),
            cells: self.cells,
            reason: Reason::WrongLaw,
            own: None,
            breaks: Vec::new(),
            order: None,
            grows: true,
            distances: false,
        }
    }
}

/// The categories by their counts.
fn counted(categories: &Arc<Categories>, terms: &Terms, claims: &mut Claims) -> Counted {
    let (step, reason) = (step(terms), Reason::WrongLaw);
    let law = Law::of_counts(categories.probabilities(), terms.tolerance + step + ULPS * f64::EPSILON);
    let of = rank(categories, |categories, row| categories.category(row[0]).map(|index| index as f64 + 0.5));
    let counted = Counted::add(law.grained(Grain::of_ranks(terms.bits, 0.0)), &COLUMNS[..1], of, claims);
    claims.push(LawAgreement { cells: counted.cells, reason });
    claims.push(CountLaw { law: counted.follows(), masses: categories.probabilities().to_vec() });
    let shares = batches::shares(&counted.law, counted.index, reason, terms, claims);
    batches::push(shares, claims);
    counted
}

/// What is left of the uniforms, alone and together with the categories.
fn remapped(categories: &Arc<Categories>, terms: &Terms, claims: &mut Claims) {
    // a piece of mass m has uniforms in steps of step/m, and there are two pieces for each category at the most
    let blur = 2.0 * categories.probabilities().len() as f64 * step(terms);
    let uniform = || {
        let law = Law::new(1.0, terms.tolerance + blur, |rank| 1.0 - rank);
        law.grained(Grain::of_ranks(terms.bits, blur))
    };
    let alone = rank(categories, |_, row| Some(row[1]));
    let second = Counted::add(uniform(), COLUMNS, alone, claims);
    let both = rank(categories, |categories, row| {
        let index = categories.category(row[0])?;
        Some(categories.below(index) + categories.probability(index) * row[1])
    });
    let joint = Counted::add(uniform(), COLUMNS, both, claims);
    claims.push(SecondRank(LawClaim { grows: false, ..second.follows() }));
    let shares = batches::shares(&second.law, second.index, Reason::WrongLaw, terms, claims);
    batches::push(shares.map(SecondRank), claims);
    let words = "category and remapped uniform give back the uniform on the whole of [0, 1)";
    claims.push(JointRanks { law: joint.law.clone(), cells: joint.cells, reason: Reason::WrongLaw, words });
    if terms.stands(Withdrawal::Independent) {
        let scores = Arc::new(Scores::new(&second.law));
        let rows = terms.ordered_rows(false);
        let lags = claims.folds.add(Lags { scores: scores.clone(), index: second.index, rows });
        claims.push(SecondRank(Order { scores, lags, cells: second.cells }));
    }
    claims.push(SecondRank(Evenness { prefix: "", law: second.law.clone(), cells: second.cells }));
    even(&joint, "joint_", claims);
}

fn even(counted: &Counted, prefix: &'static str, claims: &mut Claims) {
    claims.push(Evenness { prefix, law: counted.law.clone(), cells: counted.cells });
}

/// The step of the uniforms.
fn step(terms: &Terms) -> f64 {
    libm::ldexp(1.0, -(terms.bits as i32))
}

/// A predicate: true of a category that has a weight, with a remapped uniform if there is one.
fn inside(categories: &Arc<Categories>) -> Inside {
    let categories = categories.clone();
    Arc::new(move |row| has_weight(&categories, row[0]) && row[1..].iter().all(|u| (0.0..1.0).contains(u)))
}

fn has_weight(categories: &Categories, index: f64) -> bool {
    categories.category(index).is_some_and(|index| categories.probability(index) > 0.0)
}

/// A number of a row whose category has a weight; -1 of all others.
fn rank(categories: &Arc<Categories>, of: fn(&Categories, &[f64]) -> Option<f64>) -> RankOf {
    let categories = categories.clone();
    Arc::new(move |row| {
        if row.iter().any(|number| number.is_nan()) {
            f64::NAN
        } else if has_weight(&categories, row[0]) {
            of(&categories, row).unwrap_or(-1.0)
        } else {
            -1.0
        }
    })
}

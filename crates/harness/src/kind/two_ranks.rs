//! Rows whose law in two dimensions is told by two ranks: the distribution function of the one, and that of the other given the one
//! (Rosenblatt 1952).

use crate::experiment::{Plan, Terms};
use crate::kind::batches;
use freepath_results::Reason;
use freepath_statistics::claim::{
    Claims, Domain, EnoughRows, Evenness, JointRanks, LawAgreement, LawClaim, ObservedOrder, Order, PdfIntegral,
    SecondRank, Withdrawal, joint_rank,
};
use freepath_statistics::fold::{Cells, FoldId, Inside, Lags, Places, Rank, RankOf, Values};
use freepath_statistics::tally::Scores;
use freepath_statistics::{CellIndex, Law};
use std::sync::Arc;

/// The two ranks of a row that lies where it may; none of another.
pub(super) type RanksOf = Arc<dyn Fn(&[f64]) -> Option<[f64; 2]> + Send + Sync>;

/// What is claimed of rows with two ranks.
pub(super) struct TwoRanks {
    /// The columns of a row.
    pub(super) columns: &'static [&'static str],
    /// True of a row that lies where it may.
    pub(super) inside: Inside,
    /// Its ranks.
    pub(super) ranks: RanksOf,
    /// The uniform law, with what it may be off by.
    pub(super) law: Arc<Law>,
    /// The integral of the density that a sampler tells of any row, if it tells one.
    pub(super) pdf: Option<PdfIntegral>,
}

/// A rank by cell of the uniform law.
struct Ranked {
    cells: FoldId<Cells>,
    index: CellIndex,
}

impl TwoRanks {
    /// Rows lie where they may, their two ranks are uniform on the square, and the density that a sampler tells integrates to 1.
    pub(super) fn plan<'a>(self, external: bool, terms: &Terms) -> Plan<'a> {
        let (mut claims, reason, law) = (Claims::default(), Reason::WrongLaw, self.law.clone());
        let places = Places { columns: self.columns, inside: self.inside.clone(), atoms: Vec::new() };
        let places = claims.folds.add(places);
        claims.push(Domain { columns: self.columns, inside: self.inside.clone(), places });
        if external {
            claims.push(EnoughRows);
        }
        let first = self.ranked(|[first, _]| first, &mut claims);
        let second = self.ranked(|[_, second]| second, &mut claims);
        let joint = self.ranked(|[first, second]| joint_rank(first, second), &mut claims);
        claims.push(LawAgreement { cells: first.cells, reason });
        claims.push(follows(&law, &first));
        claims.push(SecondRank(LawClaim { grows: false, ..follows(&law, &second) }));
        let shares = batches::shares(&law, first.index, reason, terms, &mut claims);
        batches::push(shares, &mut claims);
        let shares = batches::shares(&law, second.index, reason, terms, &mut claims);
        batches::push(shares.map(SecondRank), &mut claims);
        let words = "the two ranks of a draw are uniform on the square";
        claims.push(JointRanks { law: law.clone(), cells: joint.cells, reason, words });
        if let Some(pdf) = self.pdf {
            claims.push(pdf);
        }
        let cells = [first.cells, second.cells];
        order(&law, [first, second], terms.ordered_rows(external), terms, &mut claims);
        let even = |prefix, cells| Evenness { prefix, law: law.clone(), cells };
        claims.push(even("", cells[0]));
        claims.push(SecondRank(even("", cells[1])));
        claims.push(even("joint_", joint.cells));
        Plan { claims, beside: Vec::new() }
    }

    fn ranked(&self, of: fn([f64; 2]) -> f64, claims: &mut Claims) -> Ranked {
        let index = claims.folds.cell_index();
        let values = Values::Rank(Rank { columns: self.columns, of: self.rank(of) });
        Ranked { cells: claims.folds.add(Cells { values, law: self.law.clone(), index }), index }
    }

    /// A rank of a row; -1 where there is no mass.
    fn rank(&self, of: fn([f64; 2]) -> f64) -> RankOf {
        let ranks = self.ranks.clone();
        Arc::new(move |row| {
            if row.iter().any(|x| x.is_nan()) {
                return f64::NAN;
            }
            let rank = ranks(row).map_or(-1.0, of);
            if rank > 1.0 { 1.0 } else { rank } // at the rim, by rounding
        })
    }
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
fn order(law: &Law, ranks: [Ranked; 2], rows: u64, terms: &Terms, claims: &mut Claims) {
    if !terms.stands(Withdrawal::Independent) {
        return;
    }
    let scores = Arc::new(Scores::new(law));
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

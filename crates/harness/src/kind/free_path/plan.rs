use super::FreePathKind;
use super::in_parts::{InParts, cut, works_in_parts};
use crate::experiment::{Beside, Plan, Terms};
use crate::kind::{Ray, Source, batches, escaping};
use freepath_draws::column::{AUXILIARY, COLLISIONS, T, WEIGHT};
use freepath_estimators::FreePathSampler;
use freepath_estimators::claims::FreePathClaims;
use freepath_results::Reason;
use freepath_statistics::CellIndex;
use freepath_statistics::claim::{
    AuxiliaryClaim, Bounded, Claims, ColemanClaim, EnoughRows, Escaping, Evenness, InsideRay, LawAgreement,
    LawClaim, LookupsClaim, NullPositionsClaim, ObservedOrder, Order, OwnLaw, Path, SeriesClaim, TiesClaim,
    UnitWeightClaim, Vacuum, Withdrawal, Written,
};
use freepath_statistics::fold::{
    Auxiliary, Cells, Collisions, FoldId, Folds, Histogram, Lags, Lookups, Nulls, Sentinel, Strays, Ties,
    UnitWeight, Values,
};
use freepath_statistics::hypothesis::{Cost, pair_probability};
use freepath_statistics::tally::Scores;
use std::sync::Arc;

mod laws;
mod within_cells;

pub(super) use laws::Laws;
use laws::{collided_alone, survival};

/// Sets the streams of a ray in two parts apart from those of the whole.
const IN_PARTS: u64 = 0x9e37_79b9_7f4a_7c15;

/// The claims of the sampler: of a file nothing that is not true of any right sampler.
fn said<'a>(ray: Ray<'a>, source: &Source<'a, FreePathKind>) -> FreePathClaims<'a> {
    match source {
        Source::Sampler(sampler) => sampler.claims(ray.truth),
        Source::Control => FreePathClaims { bounded: false, lookups: Some(0.0), ..FreePathClaims::default() },
        Source::External(_) => FreePathClaims { bounded: false, ..FreePathClaims::default() },
    }
}

/// Claims on free paths while they are put together.
struct Builder<'a, 'b> {
    ray: Ray<'a>,
    source: &'b Source<'a, FreePathKind>,
    terms: &'b Terms<'b>,
    said: FreePathClaims<'a>,
    laws: Laws,
    reason: Reason,
    claims: Claims<'a>,
    beside: Vec<Beside<'a>>,
    index: CellIndex,
    cells: FoldId<Cells>,
    lookups: FoldId<Lookups>,
}

pub(super) fn plan<'a>(ray: Ray<'a>, source: &Source<'a, FreePathKind>, terms: &Terms) -> Plan<'a> {
    let mut builder = Builder::new(ray, source, terms);
    builder.support();
    if terms.stands(Withdrawal::Truth) {
        builder.law();
        builder.coleman();
    }
    builder.order();
    if terms.stands(Withdrawal::Truth) {
        builder.in_parts();
        builder.auxiliary();
        builder.cost();
    }
    Plan { claims: builder.claims, beside: builder.beside }
}

impl<'a, 'b> Builder<'a, 'b> {
    fn new(ray: Ray<'a>, source: &'b Source<'a, FreePathKind>, terms: &'b Terms<'b>) -> Self {
        let (said, laws, mut claims) = (said(ray, source), Laws::of(ray, source, terms), Claims::default());
        let index = claims.folds.cell_index();
        let cells = claims.folds.add(Cells { values: Values::Column(T), law: laws.truth.clone(), index });
        let lookups = claims.folds.add(Lookups);
        let reason = if laws.own.is_some() { Reason::Biased } else { Reason::WrongLaw };
        Self { ray, source, terms, said, laws, reason, claims, beside: Vec::new(), index, cells, lookups }
    }

    /// Claims that hold whatever the law: look-ups and distances lie where they may.
    fn support(&mut self) {
        let (lookups, cells, external) = (self.lookups, self.cells, self.source.is_external());
        if self.said.bounded {
            self.claims.push(Bounded { lookups });
        }
        self.claims.push(InsideRay { lookups });
        if external {
            self.claims.push(EnoughRows);
        }
        self.path();
        if !external {
            let other = self.claims.folds.add(UnitWeight { column: WEIGHT });
            self.claims.push(UnitWeightClaim { column: WEIGHT, other });
        }
        self.claims.push(LawAgreement { cells, reason: self.reason });
    }

    /// Where distances lie, and how escapes are written.
    fn path(&mut self) {
        let (length, cells) = (self.ray.truth.length(), self.cells);
        let strays = self.claims.folds.add(Strays { column: T, length });
        let remedy: fn(Sentinel) -> String = match self.source {
            Source::External(rows) if rows.finished() => escaping::of_file,
            Source::External(_) => escaping::of_program,
            Source::Control | Source::Sampler(_) => escaping::of_sampler,
        };
        let escapes = Escaping { share: self.laws.truth.atom(), remedy };
        self.claims.push(Path { column: T, length, cells, strays, escapes });
    }

    /// The medium's law, and the one that the sampler has by design.
    fn law(&mut self) {
        let (Laws { truth, own }, cells) = (&self.laws, self.cells);
        self.claims.push(LawClaim {
            law: truth.clone(),
            cells,
            reason: self.reason,
            own: own.clone(),
            breaks: self.ray.truth.breaks().to_vec(),
            order: self.said.order,
            grows: true,
            distances: true,
        });
        let shares = batches::shares(truth, self.index, self.reason, self.terms, &mut self.claims);
        batches::push(shares, &mut self.claims);
        if let Some(law) = own.clone() {
            self.claims.push(OwnLaw { law, cells, continuous: self.said.continuous });
        }
        self.within_cells();
        if self.laws.own.is_none() {
            let (law, medium) = (self.laws.truth.clone(), self.ray.truth);
            let empty = Box::new(move |from, to| medium.extrema(from, to).1 <= 0.0);
            self.claims.push(Vacuum { law, empty, cells });
        }
    }

    /// Tentative collisions with the distance.
    fn coleman(&mut self) {
        if !self.said.coleman {
            return;
        }
        let (law, medium) = (self.laws.truth.clone(), self.ray.truth);
        let histogram = Histogram::Joint(law.clone(), self.index);
        let collisions = self.claims.folds.add(Collisions { column: COLLISIONS, histogram });
        let null_depth = Box::new(move |t| {
            let depth = medium.majorants().depth(t) - medium.tau(t);
            if depth < 0.0 { 0.0 } else { depth }
        });
        self.claims.push(ColemanClaim { law, null_depth, collisions });
    }

    /// Ties, and neighbours in drawing order.
    fn order(&mut self) {
        if !self.terms.stands(Withdrawal::Independent) {
            return;
        }
        let (cells, followed) = (self.cells, self.laws.followed());
        let rows = self.terms.ordered_rows(self.source.is_external());
        let scores = Arc::new(Scores::new(followed));
        let lags = self.claims.folds.add(Lags { scores: scores.clone(), index: self.index, rows });
        if !self.terms.stands(Withdrawal::Truth) {
            self.claims.push(ObservedOrder { scores, lags, cells });
            return;
        }
        if self.said.continuous && followed.collided() > 0.0 {
            let pair = pair_probability(followed, self.terms.bits);
            let ties = self.claims.folds.add(Ties { column: T });
            let written = match self.source {
                Source::External(rows) if rows.is_text() => Written::Text,
                Source::External(_) => Written::Binary,
                Source::Control | Source::Sampler(_) => Written::Here,
            };
            self.claims.push(TiesClaim { pair, ties, cells, written });
        }
        self.claims.push(Order { scores, lags, cells });
        self.claims.push(Evenness { prefix: "", law: self.laws.followed().clone(), cells });
    }

    /// Claims on the places of tentative collisions, and on the ray in two parts.
    fn in_parts(&mut self) {
        if self.said.coleman && self.said.bounded {
            let nulls = self.claims.folds.add(Nulls { law: self.laws.truth.clone(), index: self.index });
            self.claims.push(NullPositionsClaim { nulls });
        }
        let Some(sampler) = self.source.sampler().filter(|_| self.said.parts && self.laws.own.is_none()) else {
            return;
        };
        let cut = cut(self.ray.truth);
        if !works_in_parts(sampler, self.ray.truth, cut) {
            return;
        }
        let (law, reason, mut folds) = (self.laws.truth.clone(), self.reason, Folds::default());
        let index = folds.cell_index();
        let cells = folds.add(Cells { values: Values::Column(T), law: law.clone(), index });
        let lookups = folds.add(Lookups);
        self.claims.push(SeriesClaim { law, beside: self.beside.len(), cells, lookups, reason });
        let experiment = Box::new(InParts { sampler, ray: self.ray, cut });
        self.beside.push(Beside { experiment, folds, salt: IN_PARTS });
    }

    /// A number that comes with each draw and says nothing of it.
    fn auxiliary(&mut self) {
        let wanted = self.source.sampler().is_some_and(FreePathSampler::has_auxiliary);
        if wanted && self.terms.stands(Withdrawal::Independent) {
            let scores = Arc::new(Scores::new(self.laws.followed()));
            let numbers = self.claims.folds.add(Auxiliary { column: AUXILIARY, scores, index: self.index });
            self.claims.push(AuxiliaryClaim { numbers });
        }
    }

    fn cost(&mut self) {
        let Terms { rows, tolerance, .. } = *self.terms;
        if let Some(expected) = self.said.lookups {
            let cost = Cost { expected, error: self.said.lookups_error, slack: tolerance };
            self.claims.push(LookupsClaim { cost, lookups: self.lookups, rows });
        }
    }
}

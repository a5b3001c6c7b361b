use super::in_system::{InSystem, Known};
use super::{Walk, remarks};
use crate::experiment::{Plan, Terms};
use crate::kind::Source;
use crate::kind::column_order::OrderedColumn;
use crate::kind::stated::{StatedMean, spread};
use freepath_draws::column::{COLLISIONS, WEIGHT};
use freepath_results::Reason;
use freepath_statistics::Law;
use freepath_statistics::claim::{
    Claims, CountColumn, CountLaw, Domain, EfficiencyClaim, InfiniteVariance, LawClaim, LookupsClaim, Moments,
    SecondMomentClaim, Withdrawal,
};
use freepath_statistics::fold::{
    Cells, Collisions, FoldId, Histogram, Inside, Lookups, Places, Rank, Values, Weights,
};
use freepath_statistics::hypothesis::{Cost, MeanClaim, SecondMoment};
use std::sync::Arc;

/// The column of the scores.
const SCORES: &[&str] = &[WEIGHT];
/// What elimination may leave of an error, relative to the solution.
pub(super) const SOLVED: f64 = 1e-11;

/// Claims on the scores of walks while they are put together.
struct Builder<'a, 'b> {
    terms: &'b Terms<'b>,
    known: Option<Arc<Known>>,
    mean: StatedMean,
    claims: Claims<'a>,
    weights: FoldId<Weights>,
    lookups: FoldId<Lookups>,
}

/// Scores are finite and have the mean and the second moment of their system; walks have its lengths, and what counts visits their law.
pub(super) fn plan<'a>(scene: &'a InSystem, source: &Source<'a, Walk>, terms: &Terms) -> Plan<'a> {
    let known = known(scene, source);
    let mut builder = Builder::new(known, mean(scene, source, terms), terms);
    builder.support(source.is_external());
    if terms.stands(Withdrawal::Truth) {
        builder.moments();
        builder.counts();
        builder.cost();
        remarks::push(scene, &mut builder.claims);
    }
    OrderedColumn::only(WEIGHT).claim(source.is_external(), terms, &mut builder.claims);
    Plan { claims: builder.claims, beside: Vec::new() }
}

fn known(scene: &InSystem, source: &Source<Walk>) -> Option<Arc<Known>> {
    source.sampler().and_then(|sampler| sampler.method()).and_then(|method| scene.known(method))
}

/// The mean of the scores.
pub(super) fn mean(scene: &InSystem, source: &Source<Walk>, terms: &Terms) -> StatedMean {
    let (known, expected) = (known(scene, source), scene.mean.unwrap_or(f64::NAN));
    let (variance, skewness) = match source {
        Source::Control => (Some(0.0), None),
        Source::Sampler(_) | Source::External(_) => {
            known.as_ref().map_or((None, None), |known| spread(&known.moments))
        }
    };
    let known = MeanClaim {
        expected,
        slack: terms.tolerance + SOLVED * expected.abs(),
        binary: false,
        range: known.and_then(|known| known.range),
        variance,
        skewness,
    };
    StatedMean::new(known, None, terms)
}

impl<'b> Builder<'_, 'b> {
    fn new(known: Option<Arc<Known>>, mean: StatedMean, terms: &'b Terms<'b>) -> Self {
        let mut claims = Claims::default();
        let weights = mean.weights(&mut claims);
        let lookups = claims.folds.add(Lookups);
        Self { terms, known, mean, claims, weights, lookups }
    }

    /// Claims that hold whatever the mean, and those that compare estimators and settings.
    fn support(&mut self, external: bool) {
        let (weights, lookups, mean) = (self.weights, self.lookups, self.mean);
        mean.support(weights, external, self.terms, &mut self.claims);
        let moments = self.known.as_ref().map(|known| known.moments).filter(|moments| moments[3].is_finite());
        let (truth, design_bias) = (mean.truth, mean.design_bias());
        self.claims.push(EfficiencyClaim { weights, lookups, truth, design_bias, moments });
    }

    /// The mean and the second moment, or why neither can be judged.
    fn moments(&mut self) {
        let (weights, StatedMean { truth, .. }) = (self.weights, self.mean);
        let radius = self.known.as_ref().and_then(|known| known.radius);
        if let Some(radius) = radius {
            let why = format!("the spectral radius of H^2 / P is {radius:.6}, not below 1");
            return self.claims.push(InfiniteVariance { expected: truth.expected, why });
        }
        self.mean.means(weights, None, self.terms, &mut self.claims);
        let moments = self.known.as_ref().map(|known| known.moments);
        if let Some([_, m2, _, m4, _, m6]) = moments.filter(|_| self.terms.stands(Withdrawal::SecondMoment)) {
            let (moments, sums) = ([m2, m4, m6], Moments::Column(weights));
            let moment = SecondMoment { moments, error: SOLVED, slack: truth.slack };
            self.claims.push(SecondMomentClaim { name: "second_moment".into(), sums, moment });
        }
    }

    /// The law of a score that counts ends or visits.
    fn counts(&mut self) {
        let Some(counting) = self.known.as_ref().and_then(|known| known.counting.as_ref()) else { return };
        let (unit, masses) = (counting.unit, counting.masses.clone());
        let law = Arc::new(Law::of_counts(&masses, self.terms.tolerance + SOLVED));
        let last = masses.len() - 1;
        let inside: Inside = Arc::new(move |row| counted(row[0] / unit, last) >= 0.0);
        let places = Places { columns: SCORES, inside: inside.clone(), atoms: Vec::new() };
        let places = self.claims.folds.add(places);
        self.claims.push(Domain { columns: SCORES, inside, places });
        let of = Arc::new(move |row: &[f64]| counted(row[0] / unit, last));
        let (values, index) = (Values::Rank(Rank { columns: SCORES, of }), self.claims.folds.cell_index());
        let cells = self.claims.folds.add(Cells { values, law: law.clone(), index });
        let (reason, own, breaks) = (Reason::WrongLaw, None, Vec::new());
        let law = LawClaim { law, cells, reason, own, breaks, order: None, grows: false, distances: false };
        self.claims.push(CountLaw { law, masses });
    }

    /// The states of a walk: their mean and their law.
    fn cost(&mut self) {
        let Terms { rows, tolerance, .. } = *self.terms;
        let Some(known) = self.known.clone() else { return };
        if let Some(expected) = known.length {
            let cost = Cost { expected, error: SOLVED * expected, slack: 0.0 };
            self.claims.push(LookupsClaim { cost, lookups: self.lookups, rows });
        }
        let counts = self.claims.folds.add(Collisions { column: COLLISIONS, histogram: Histogram::Marginal });
        let (masses, slack) = (known.lengths.clone(), tolerance + SOLVED);
        self.claims.push(CountColumn { prefix: "length_", words: "states of a walk", masses, counts, slack });
    }
}

/// The cell of a number that should be whole; -1 of one that is not.
fn counted(number: f64, last: usize) -> f64 {
    let whole = number.round();
    let off = (number - whole).abs() <= 1e-9 * (1.0 + number.abs());
    match (number.is_nan(), off && whole >= 0.0) {
        (true, _) => f64::NAN,
        (false, false) => -1.0,
        (false, true) => 0.5 + if whole < last as f64 { whole } else { last as f64 },
    }
}

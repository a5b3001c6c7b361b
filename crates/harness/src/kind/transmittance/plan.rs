use super::Transmittance;
use crate::experiment::{Plan, Terms};
use crate::kind::column_order::OrderedColumn;
use crate::kind::stated::StatedMean;
use crate::kind::{Ray, Source};
use crate::subject::Route;
use freepath_draws::column::{COLLISIONS, WEIGHT};
use freepath_estimators::claims::TransmittanceClaims;
use freepath_statistics::claim::{
    Bounded, Claims, EfficiencyClaim, InsideRay, LookupsClaim, Moments, PoissonClaim, SecondMomentClaim,
    Withdrawal,
};
use freepath_statistics::fold::{Collisions, FoldId, Histogram, Lookups, Weights};
use freepath_statistics::hypothesis::{Cost, MeanClaim, SecondMoment};

/// The claims of the estimator: of a file nothing that is not true of any right estimator.
pub(super) fn said(ray: Ray, source: &Source<Transmittance>) -> TransmittanceClaims {
    match source {
        Source::Sampler(estimator) => estimator.claims(ray.truth),
        Source::Control => closed_form(ray),
        Source::External(_) => TransmittanceClaims { bounded: false, ..TransmittanceClaims::default() },
    }
}

fn closed_form(ray: Ray) -> TransmittanceClaims {
    let transmittance = ray.transmittance();
    TransmittanceClaims {
        bounded: false,
        moments: Some(std::array::from_fn(|k| libm::pow(transmittance, (k + 1) as f64))),
        range: Some((0.0, 1.0)),
        lookups: Some(0.0),
        ..TransmittanceClaims::default()
    }
}

/// The most that quadrature may leave of the moments, relative to each, for a variance by formula to be one.
const MOST_LEFT: f64 = 1e-9;

/// The mean of the estimates.
pub(super) struct Mean {
    /// T, and the mean that the estimator has by design, if that is another.
    pub(super) stated: StatedMean,
    /// E[X^k] by formula.
    pub(super) moments: Option<[f64; 6]>,
}

impl Mean {
    pub(super) fn of(ray: Ray, source: &Source<Transmittance>, terms: &Terms) -> Self {
        let (claims, transmittance) = (said(ray, source), ray.transmittance());
        let exact = claims.moments.filter(|_| claims.moments_error <= MOST_LEFT);
        let (variance, skewness) = exact.as_ref().map(spread).unzip();
        let truth = MeanClaim {
            expected: transmittance,
            slack: terms.tolerance + transmittance * ray.truth.tau_error(),
            binary: claims.binary,
            range: claims.range,
            variance,
            skewness,
        };
        let own = |expected| MeanClaim {
            expected,
            slack: terms.tolerance + (1e-10 + claims.moments_error) * transmittance,
            ..truth
        };
        let known = terms.stands(Withdrawal::Truth);
        let second = known && !claims.binary && terms.stands(Withdrawal::SecondMoment);
        let own = claims.own_mean.map(own).filter(|_| known);
        Self { stated: StatedMean::new(truth, own, terms), moments: claims.moments.filter(|_| second) }
    }
}

/// Variance and skewness from raw moments; the skewness is NaN, not known, where cancellation leaves too few digits of it.
fn spread(moments: &[f64; 6]) -> (f64, f64) {
    let [m1, m2, m3, ..] = *moments;
    let variance = m2 - m1 * m1;
    let third = m3 - 3.0 * m1 * m2 + 2.0 * m1 * m1 * m1;
    let skewness = if variance > 1e-9 * m1 * m1 { third / (variance * variance.sqrt()) } else { f64::NAN };
    (if variance > 0.0 { variance } else { 0.0 }, skewness)
}

/// Claims on estimates while they are put together.
struct Builder<'a, 'b> {
    terms: &'b Terms<'b>,
    said: TransmittanceClaims,
    mean: Mean,
    claims: Claims<'a>,
    weights: FoldId<Weights>,
    lookups: FoldId<Lookups>,
}

pub(super) fn plan<'a>(ray: Ray<'a>, source: &Source<'a, Transmittance>, terms: &Terms) -> Plan<'a> {
    let mut builder = Builder::new(said(ray, source), Mean::of(ray, source, terms), terms);
    builder.support(source.is_external());
    if terms.stands(Withdrawal::Truth) {
        builder.mean();
        builder.cost();
    }
    OrderedColumn::only(WEIGHT).claim(source.is_external(), terms, &mut builder.claims);
    Plan { claims: builder.claims, beside: Vec::new() }
}

impl<'b> Builder<'_, 'b> {
    fn new(said: TransmittanceClaims, mean: Mean, terms: &'b Terms<'b>) -> Self {
        let mut claims = Claims::default();
        let weights = mean.stated.weights(&mut claims);
        let lookups = claims.folds.add(Lookups);
        Self { terms, said, mean, claims, weights, lookups }
    }

    /// Claims that hold whatever the mean, and those that compare estimators and settings.
    fn support(&mut self, external: bool) {
        let (weights, lookups, stated) = (self.weights, self.lookups, self.mean.stated);
        if self.said.bounded {
            self.claims.push(Bounded { lookups });
        }
        self.claims.push(InsideRay { lookups });
        stated.support(weights, external, self.terms, &mut self.claims);
        let (truth, design_bias) = (stated.truth, stated.design_bias());
        let moments = self.mean.moments.filter(|_| self.said.moments_error <= MOST_LEFT);
        self.claims.push(EfficiencyClaim { weights, lookups, truth, design_bias, moments });
    }

    /// The mean, the one that the estimator has by design, and the second moment.
    fn mean(&mut self) {
        let (weights, Mean { stated, moments }) = (self.weights, &self.mean);
        let (moments, slack) = (*moments, stated.truth.slack);
        stated.means(weights, self.said.order, self.terms, &mut self.claims);
        if let Some([_, m2, _, m4, _, m6]) = moments {
            let (name, sums) = ("second_moment".to_string(), Moments::Column(weights));
            let error = self.said.moments_error;
            let moment = SecondMoment { moments: [m2, m4, m6], error, slack };
            self.claims.push(SecondMomentClaim { name, sums, moment });
        }
    }

    /// Collisions and look-ups. One estimate at a time tells no collisions.
    fn cost(&mut self) {
        let Terms { rows, tolerance: slack, route, .. } = *self.terms;
        if let Some(mean) = self.said.poisson.filter(|_| route == Route::Block) {
            let fold = Collisions { column: COLLISIONS, histogram: Histogram::Marginal };
            let counts = self.claims.folds.add(fold);
            self.claims.push(PoissonClaim { mean, counts, slack });
        }
        if let Some(expected) = self.said.lookups {
            let cost = Cost { expected, error: self.said.lookups_error, slack };
            self.claims.push(LookupsClaim { cost, lookups: self.lookups, rows });
        }
    }
}

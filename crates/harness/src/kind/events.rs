//! Weighted means of events along a ray: of a chromatic sampler, or of weighted free paths.

use super::batches;
use crate::experiment::{Declared, Terms};
use freepath_draws::column::{self, T, channel};
use freepath_results::Reason;
use freepath_statistics::claim::{
    BoundedMean, Claims, CountedPath, Escaping, EventClaim, EventWeights, FiniteRow, Moments, SecondMomentClaim,
    WeightedLawClaim, Withdrawal, bounds, portfolio,
};
use freepath_statistics::fold::{Batched, Event, EventSums, FoldId, Strays, WealthSums, Weighed};
use freepath_statistics::hypothesis::{MeanClaim, SecondMoment, WeightedLaw};
use freepath_statistics::tally::Bins;
use std::sync::Arc;

/// The weighted mean of one event in one channel.
pub(super) struct EventMean {
    /// The channel.
    pub(super) channel: usize,
    /// The event.
    pub(super) event: Event,
    /// The name of its test.
    pub(super) name: String,
    /// E[w; event].
    pub(super) mean: MeanClaim,
    /// E[w^2; event], E[w^4; event] and E[w^6; event], where a formula is known.
    pub(super) moments: Option<[f64; 3]>,
    /// How far quadrature may put them off, relative to each.
    pub(super) moments_error: f64,
    /// Nothing says that the weights have a variance: no formula for the event, nor for any scattering.
    pub(super) keeps_tail: bool,
    /// All that the channel expects, of every event together.
    pub(super) whole: f64,
    /// Of scattering: the law of the distance under the weights.
    pub(super) law: Option<WeightedLaw>,
}

/// The folds of events, and what all of their weights must be.
pub(super) struct Events {
    means: Vec<EventMean>,
    sums: Vec<FoldId<EventSums>>,
    /// The sums of all weights in bins of t, if laws are judged by them.
    weighed: Option<FoldId<Weighed>>,
}

impl Events {
    /// Folds of `means` and, of so many channels, of the weights in `bins`.
    pub(super) fn tally(means: Vec<EventMean>, channels: usize, bins: Option<Bins>, claims: &mut Claims) -> Self {
        let fold = |mean: &EventMean| EventSums {
            column: channel(mean.channel).into_owned(),
            distance: T,
            event: mean.event,
            center: mean.mean.expected,
            keeps_tail: mean.keeps_tail && mean.mean.range.is_none(),
        };
        let sums = means.iter().map(|mean| claims.folds.add(fold(mean))).collect();
        let weighed = bins.map(|bins| {
            let columns = (0..channels).map(channel).collect();
            let (bins, index) = (Arc::new(bins), claims.folds.cell_index());
            claims.folds.add(Weighed { columns, distance: T, bins, index })
        });
        Self { means, sums, weighed }
    }

    /// Every weight is finite, and within its range if one is declared.
    pub(super) fn finite(&self, terms: &Terms, claims: &mut Claims) {
        let (range, tolerance) = (terms.declared.range.map(with_zero), terms.tolerance);
        claims.push(EventWeights { sums: self.sums.clone(), range, tolerance });
    }

    /// Every distance lies on the ray, where no law counts them.
    pub(super) fn path(length: f64, escapes: Escaping, claims: &mut Claims) {
        let strays = claims.folds.add(Strays { column: T, length });
        claims.push(CountedPath { column: T, length, strays, escapes });
    }

    /// Every weight of a row is finite, row by row.
    pub(super) fn rows(channels: usize, claims: &mut Claims) {
        claims.push(FiniteRow { columns: (0..channels).map(|k| channel(k).into_owned()).collect() });
    }

    /// Each event has its mean and, where a formula is known, its second moment; scattering a law as well.
    pub(super) fn means(self, terms: &Terms, claims: &mut Claims) {
        for (event, sums) in self.means.into_iter().zip(self.sums) {
            let EventMean { channel, whole, mean: MeanClaim { expected: scattered, .. }, .. } = event;
            let law = event.law.clone();
            event.claim(sums, terms, claims);
            if let (Some(law), Some(weighed)) = (law, self.weighed) {
                claims.push(WeightedLawClaim { channel, law, sums: weighed, scatter: sums, scattered, whole });
            }
        }
    }
}

impl EventMean {
    fn claim(self, sums: FoldId<EventSums>, terms: &Terms, claims: &mut Claims) {
        let Self { channel, event, name, mean, moments, moments_error: error, whole, .. } = self;
        let (second, bounded) = (format!("second_moment_{name}"), format!("bounded_mean_{name}"));
        let fold = Batched::event(column::channel(channel), T, event);
        batches::mean((&name, Reason::Biased), Moments::Event(sums), fold, mean, terms, claims);
        claims.push(EventClaim { name, channel, event, mean, whole, sums });
        if bounds(&mean) && terms.stands(Withdrawal::Independent) {
            let column = column::channel(channel);
            let fold = |portfolio| WealthSums { column, event: Some((T, event)), portfolio };
            let wealth = portfolio(&mean).map(|portfolio| claims.folds.add(fold(portfolio)));
            let (sums, reason) = (Moments::Event(sums), Reason::Biased);
            claims.push(BoundedMean { name: bounded, sums, wealth, mean, reason });
        }
        if let Some(moments) = moments {
            let sums = Moments::Event(sums);
            let moment = SecondMoment { moments, error, slack: mean.slack };
            claims.push(SecondMomentClaim { name: second, sums, moment });
        }
    }
}

/// The range of a weight that counts as 0 where its event does not happen.
fn with_zero(range: [f64; 2]) -> (f64, f64) {
    let [low, high] = range;
    (if low < 0.0 { low } else { 0.0 }, if high > 0.0 { high } else { 0.0 })
}

/// The claim on the weights of an event.
pub(super) fn weights(
    expected: f64,
    moments: Option<[f64; 3]>,
    probability: Option<f64>,
    slack: f64,
    declared: Declared,
) -> MeanClaim {
    let variance = moments.map(|[m2, ..]| m2 - expected * expected);
    MeanClaim {
        expected,
        slack,
        binary: false,
        range: declared.range.map(with_zero),
        variance: variance.map(|v| if v > 0.0 { v } else { 0.0 }),
        skewness: probability.map(|p| skewness(p, expected, variance)),
    }
}

/// Skewness of an event that happens or not: its weights are about as skew, whether or not it is ever seen, but for what they scatter besides.
fn skewness(p: f64, expected: f64, variance: Option<f64>) -> f64 {
    let (hit, chance) = (expected / p, p * (1.0 - p));
    let share = variance.map_or(1.0, |variance| hit * hit * chance / variance);
    let share = if share < 1.0 { share } else { 1.0 };
    (1.0 - 2.0 * p) / chance.sqrt() * (share * share.sqrt())
}

#[cfg(test)]
mod tests {
    use super::skewness;

    #[test]
    fn an_event_that_is_all_but_certain_is_as_skew_as_its_weights_allow() {
        let close = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-6;
        let rare = 0.9998 / 9.999e-5_f64.sqrt();
        assert!(close(skewness(1e-4, 1e-4, None), rare) && close(skewness(1e-4, 1e-4, Some(1e-9)), rare));
        assert!(skewness(1.0 - 1e-9, 1.0, None) < -1e4 && skewness(1.0 - 1e-9, 1.0, Some(0.5)).abs() < 1e-8);
        assert!(!(skewness(1.0, 1.0, Some(0.5)).abs() > 0.0), "none, as there is no other event");
    }
}

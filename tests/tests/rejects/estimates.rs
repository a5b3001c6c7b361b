//! Estimates of wrong mean, spread or cost, and those that no test may judge.

use crate::path::{LENGTH, MU, medium};
use freepath_draws::random::{exponential, uniform};
use freepath_draws::{Draws, PathColumns, Streams};
use freepath_estimators::claims::TransmittanceClaims;
use freepath_estimators::transmittance::RatioTracking;
use freepath_estimators::{Extinction, FreePath, Medium, TransmittanceEstimator};
use freepath_harness::kind::Ray;
use freepath_harness::subject::Subject;
use freepath_results::{Reason, Verdict};
use freepath_tests::{Judgement, judgement, transmittance};
use rand::Rng;

/// Ratio tracking, what it gives changed, and its claims.
pub(crate) struct Estimator {
    /// Look-ups for each tentative collision.
    pub(crate) lookups: u32,
    /// From the walk and one more uniform.
    pub(crate) change: fn(FreePath, f64) -> FreePath,
    pub(crate) claims: fn(&dyn Medium) -> TransmittanceClaims,
}

impl TransmittanceEstimator for Estimator {
    fn estimate(&self, medium: &dyn Extinction, rng: &mut dyn Rng) -> f64 {
        (self.change)(ratio(medium, rng, self.lookups), uniform(rng)).weight
    }
    fn estimate_block(&self, medium: &dyn Extinction, streams: &Streams, out: &mut Draws) {
        let (mut rng, mut columns) = (streams.rng(), PathColumns::of(out));
        for row in 0..columns.rows() {
            let path = (self.change)(ratio(medium, &mut rng, self.lookups), uniform(&mut rng));
            columns.put(row, path.t, path.weight, path.collisions);
        }
    }
    fn claims(&self, truth: &dyn Medium) -> TransmittanceClaims {
        (self.claims)(truth)
    }
}

pub(crate) fn changed(change: fn(FreePath, f64) -> FreePath) -> Estimator {
    Estimator { lookups: 1, change, claims: of_ratio }
}

fn weighing(path: FreePath, factor: f64) -> FreePath {
    FreePath { weight: factor * path.weight, ..path }
}

/// Ratio tracking under twice the medium's extinction, every tentative collision looked up `lookups` times.
fn ratio(medium: &dyn Extinction, rng: &mut dyn Rng, lookups: u32) -> FreePath {
    let rate = medium.majorants().mu_bar_at(0.0);
    let (mut t, mut weight, mut collisions) = (0.0, 1.0, 0);
    loop {
        t += exponential(rng) / rate;
        if !(t < medium.length()) {
            return FreePath { t: f64::INFINITY, weight, collisions };
        }
        let mu = (0..lookups).map(|_| medium.mu(t)).last().unwrap_or(f64::NAN);
        (weight, collisions) = (weight * (1.0 - mu / rate), collisions + 1);
    }
}

pub(crate) fn of_ratio(truth: &dyn Medium) -> TransmittanceClaims {
    RatioTracking {}.claims(truth)
}

pub(crate) fn of_estimate(estimator: &Estimator, draws: u64) -> Judgement {
    let inner = medium();
    let majorants = freepath_estimators::Majorants::constant(2.0 * MU, LENGTH).measured(&inner);
    let truth = freepath_estimators::Under::new(std::sync::Arc::new(inner), majorants);
    let ray = Ray::of(&truth);
    judgement(&Subject { draws, ..Subject::new(&transmittance(estimator, ray)) }, 5)
}

pub(crate) fn estimates() -> Vec<(&'static str, Reason, Judgement)> {
    let more = |path: FreePath, u: f64| FreePath { collisions: path.collisions + u32::from(u < 0.05), ..path };
    let doubled = Estimator { lookups: 2, ..changed(|path, _| path) };
    let of = |change, draws| of_estimate(&changed(change), draws);
    let bias = of(|path, _| weighing(path, 1.03), 400_000);
    let spread = of(|path, u| weighing(path, if u < 0.5 { 1.5 } else { 0.5 }), 400_000);
    vec![
        ("lookups", Reason::WrongCost, of_estimate(&doubled, 400_000)),
        ("poisson_count", Reason::WrongCost, of(more, 200_000)),
        ("mean", Reason::Biased, bias),
        ("bounded_mean", Reason::Biased, of(|path, _| weighing(path, 0.95), 400_000)),
        ("second_moment", Reason::WrongVariance, spread),
    ]
}

/// Weights of unknown range and moments: what cannot be judged by the central limit theorem is not.
#[test]
fn heavy_and_rare_weights_are_inconclusive_and_tame_ones_pass() {
    let unknown = |change| {
        let claims = |_: &dyn Medium| TransmittanceClaims::default();
        of_estimate(&Estimator { claims, ..changed(change) }, 400_000).decision
    };
    // (1 - k) (1 - u)^-k has mean 1 and a Pareto tail of shape k
    let heavy = unknown(|path, u| weighing(path, 0.3 * libm::pow(1.0 - u, -0.7)));
    let rare = unknown(|path, u| weighing(path, if u < 1e-4 { 1e4 } else { 0.0 }));
    let tame = unknown(|path, _| path);
    let light = unknown(|path, u| weighing(path, 0.9 * libm::pow(1.0 - u, -0.1)));
    for (decision, reason) in [(heavy, Reason::HeavyTail), (rare, Reason::RareEvent)] {
        assert_eq!((decision.verdict, decision.reasons[0]), (Verdict::Inconclusive, reason), "{decision:?}");
    }
    for decision in [tame, light] {
        assert_eq!(decision.verdict, Verdict::Pass, "{decision:?}");
    }
}

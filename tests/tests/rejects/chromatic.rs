//! Chromatic draws of wrong weights or densities.

use crate::path::LENGTH;
use freepath_draws::random::uniform;
use freepath_estimators::ChromaticSampler;
use freepath_estimators::chromatic::AnyChromatic;
use freepath_estimators::claims::{Channel, ChromaticClaims};
use freepath_estimators::medium::Chromatic;
use freepath_harness::subject::Subject;
use freepath_results::Reason;
use freepath_tests::{Judgement, judgement};
use rand::Rng;

/// The balance heuristic, its weights changed.
struct Weights {
    inner: AnyChromatic,
    change: fn(f64, f64) -> f64,
    pdf: f64,
    balanced: bool,
}

impl ChromaticSampler for Weights {
    fn sample(&self, channels: &[Channel], rng: &mut dyn Rng, weights: &mut [f64]) -> f64 {
        let t = self.inner.sample(channels, rng, weights);
        let u = uniform(rng);
        weights.iter_mut().for_each(|weight| *weight *= (self.change)(t, u));
        t
    }
    fn pdf(&self, channels: &[Channel], t: f64) -> Option<f64> {
        self.inner.pdf(channels, t).map(|pdf| pdf * self.pdf)
    }
    fn claims(&self, channels: &[Channel]) -> ChromaticClaims {
        ChromaticClaims { balanced: self.balanced, ..self.inner.claims(channels) }
    }
}

pub(crate) fn of_weights(change: fn(f64, f64) -> f64, pdf: f64) -> Judgement {
    judged(change, pdf, false)
}

/// Where the weights are claimed to be a function of the distance.
pub(crate) fn of_balanced(change: fn(f64, f64) -> f64) -> Judgement {
    judged(change, 1.0, true)
}

fn judged(change: fn(f64, f64) -> f64, pdf: f64, balanced: bool) -> Judgement {
    let channels = Chromatic::new(vec![0.4, 1.1, 3.0], vec![0.3, 1.0, 1.5], LENGTH).expect("channels");
    let inner = serde_json::from_str(r#"{ "balance": {} }"#).expect("a sampler");
    let sampler = Weights { inner, change, pdf, balanced };
    let experiment = freepath_tests::chromatic(&sampler, channels.medium());
    let subject = Subject::new(&experiment);
    judgement(&Subject { draws: 400_000, ..subject }, 5)
}

/// The eighth of the ray that holds `t`.
fn bin(t: f64) -> usize {
    (8.0 * t / LENGTH) as usize
}

/// 0 or 2.
fn coin(u: f64) -> f64 {
    if u < 0.5 { 2.0 } else { 0.0 }
}

pub(crate) fn chromatic() -> Vec<(&'static str, Reason, Judgement)> {
    let scatter = of_weights(|t, _| if t.is_finite() { 1.05 } else { 1.0 }, 1.0);
    let surface = of_weights(|t, _| if t.is_finite() { 1.0 } else { 0.9 }, 1.0);
    let exchange = of_weights(|t, _| if bin(t) == 3 { 1.1 } else { 1.0 }, 1.0);
    let waves = of_weights(|t, _| if (32.0 * t / LENGTH) as u32 % 2 == 1 { 1.1 } else { 0.9 }, 1.0);
    let noise = of_weights(|t, u| if t.is_finite() { coin(u) } else { 1.0 }, 1.0);
    let noisy_end = of_weights(|t, u| if t.is_finite() { 1.0 } else { coin(u) }, 1.0);
    let density = of_weights(|_, _| 1.0, 1.0 + 1e-6);
    vec![
        ("pdf_integral", Reason::WrongLaw, density),
        ("scatter_0", Reason::Biased, scatter),
        ("surface_1", Reason::Biased, surface),
        ("channel_2_weighted_16", Reason::WrongLaw, exchange),
        ("channel_0_weighted_64", Reason::WrongLaw, waves),
        ("second_moment_scatter_0", Reason::WrongVariance, noise),
        ("second_moment_surface_0", Reason::WrongVariance, noisy_end),
    ]
}

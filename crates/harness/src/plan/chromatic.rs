use super::{ChromaticMedium, ChromaticSampler, MeanClaim, Medium, Subject};
use freepath_draws::quadrature::integrate;
use freepath_estimators::claims::{Channel, ChromaticClaims};
use freepath_statistics::Law;

/// Which event a weight belongs to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// Any scattering.
    Scatter,
    /// Reaching the end of the ray.
    Surface,
    /// Scattering at t in [from, to).
    Between(f64, f64),
}

impl Event {
    /// Whether a draw at `t` is this event.
    #[inline(always)]
    #[must_use]
    pub fn holds(self, t: f64) -> bool {
        match self {
            Self::Scatter => t < f64::INFINITY,
            Self::Surface => t == f64::INFINITY,
            Self::Between(from, to) => from <= t && t < to,
        }
    }

    /// Its probability, if `mixture` are those of the channels.
    fn probability(self, channels: &[Channel], mixture: &[f64]) -> f64 {
        let of = |channel: &Channel| {
            let (mu, length) = (channel.extinction.mu(0.0), channel.extinction.length());
            match self {
                Self::Scatter => -libm::expm1(-mu * length),
                Self::Surface => libm::exp(-mu * length),
                Self::Between(from, to) => -libm::exp(-mu * from) * libm::expm1(-mu * (to - from)),
            }
        };
        channels.iter().zip(mixture).map(|(channel, q)| q * of(channel)).sum()
    }
}

/// The weighted mean of one event in one channel.
#[derive(Clone, Debug, PartialEq)]
pub struct ChannelClaim {
    /// Which channel.
    pub channel: usize,
    /// Which event.
    pub event: Event,
    /// The name of its test.
    pub name: String,
    /// E[w; event].
    pub mean: MeanClaim,
    /// E[w^2; event], E[w^4; event] and E[w^6; event], where a formula is known.
    pub moments: Option<[f64; 3]>,
    /// Nothing says that the weights have a variance: no formula for the event, nor for any scattering.
    pub tail: bool,
}

/// Every weighted mean of a chromatic sampler.
pub struct ChannelsPlan {
    /// Length of the ray.
    pub length: f64,
    /// Channel by channel: scatter, surface, then bins of t.
    pub claims: Vec<ChannelClaim>,
    /// The integral of the pdf over the ray plus the probability of the surface, if the sampler offers its pdf.
    pub pdf_integral: Option<f64>,
}

/// Bins of t in which the weighted mean is tested.
const BINS: usize = 8;

impl ChannelsPlan {
    pub(super) fn of(
        subject: &Subject,
        sampler: &dyn ChromaticSampler,
        medium: &ChromaticMedium,
        claims: &ChromaticClaims,
    ) -> Self {
        let channels = medium.channels();
        let inside = |t: f64| sampler.pdf(&channels, t).unwrap_or(f64::NAN);
        let surface = sampler.pdf(&channels, f64::INFINITY);
        let integral = |surface| surface + integrate(&inside, 0.0, medium.length(), &[]).value;
        Self { pdf_integral: surface.map(integral), ..Self::of_channels(subject, medium, claims) }
    }

    /// What any unbiased sampler of these channels must give, and what `claims` says beyond that.
    pub(super) fn of_channels(subject: &Subject, medium: &ChromaticMedium, claims: &ChromaticClaims) -> Self {
        let (channels, length) = (medium.channels(), medium.length());
        let each = |k| of_channel(subject, k, &channels, length, claims);
        let claims = (0..channels.len()).flat_map(each).collect();
        Self { length, claims, pdf_integral: None }
    }

    /// Weighted free paths in one extinction: a single channel without absorption.
    pub(super) fn of_weighted(subject: &Subject, truth: &dyn Medium) -> Self {
        let length = truth.length();
        let survival = |t: f64| libm::exp(-truth.tau(t));
        let slack = subject.tolerance * (1.0 + Law::new(length, 0.0, survival).steepness()) + truth.tau_error();
        let claim = |event, name, expected| ChannelClaim {
            channel: 0,
            event,
            name,
            mean: weights(expected, None, None, slack),
            moments: None,
            tail: true,
        };
        let bin = |bin: usize| {
            let [from, to] = [bin, bin + 1].map(|bin| length * bin as f64 / BINS as f64);
            claim(Event::Between(from, to), format!("scatter_0_bin_{bin}"), survival(from) - survival(to))
        };
        let mut claims = vec![
            claim(Event::Scatter, "scatter_0".into(), -libm::expm1(-truth.tau(length))),
            claim(Event::Surface, "surface_0".into(), survival(length)),
        ];
        claims.extend((0..BINS).map(bin));
        Self { length, claims, pdf_integral: None }
    }
}

/// Skewness of an event that happens or not: its weights are about as skew, whether or not it is ever seen.
fn skewness(p: f64) -> f64 {
    (1.0 - 2.0 * p) / (p * (1.0 - p)).sqrt()
}

/// What is claimed of the weights of an event.
fn weights(expected: f64, moments: Option<[f64; 3]>, probability: Option<f64>, slack: f64) -> MeanClaim {
    let variance = moments.map(|[m2, ..]| m2 - expected * expected);
    MeanClaim {
        expected,
        slack,
        binary: false,
        range: None,
        variance: variance.map(|v| if v > 0.0 { v } else { 0.0 }),
        skewness: probability.map(skewness),
    }
}

fn of_channel(
    subject: &Subject,
    k: usize,
    channels: &[Channel],
    length: f64,
    claims: &ChromaticClaims,
) -> Vec<ChannelClaim> {
    let (mu, albedo) = (channels[k].extinction.mu(0.0), channels[k].albedo);
    let between = |a: f64, b: f64| albedo * (libm::exp(-mu * a) - libm::exp(-mu * b));
    let edge = |bin: usize| length * bin as f64 / BINS as f64;
    let claim = |event: Event, name: String, expected: f64, moments: Option<[f64; 3]>| {
        let mixture = claims.mixture.as_ref();
        let probability = mixture.map(|q| event.probability(channels, q));
        ChannelClaim {
            channel: k,
            event,
            name,
            mean: weights(expected, moments, probability, subject.tolerance),
            moments,
            tail: moments.is_none() && (event == Event::Surface || claims.scatter_moments.is_none()),
        }
    };
    let of = |moments: &Option<Vec<[f64; 3]>>| moments.as_ref().and_then(|m| m.get(k).copied());
    let (scatter, surface) = (of(&claims.scatter_moments), of(&claims.surface_moments));
    let (scattered, through) = (between(0.0, length), libm::exp(-mu * length));
    let mut all = vec![
        claim(Event::Scatter, format!("scatter_{k}"), scattered, scatter),
        claim(Event::Surface, format!("surface_{k}"), through, surface),
    ];
    all.extend((0..BINS).map(|bin| {
        let (from, to) = (edge(bin), edge(bin + 1));
        claim(Event::Between(from, to), format!("scatter_{k}_bin_{bin}"), between(from, to), None)
    }));
    all
}

use super::{ChromaticMedium, ChromaticSampler, MeanClaim, Subject};
use freepath_estimators::claims::{Channel, ChromaticClaims};
use freepath_estimators::quadrature::integrate;

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
        let length = medium.length();
        let each = |k| of_channel(subject, k, &channels, length, claims);
        let claims = (0..channels.len()).flat_map(each).collect();
        let inside = |t: f64| sampler.pdf(&channels, t).unwrap_or(f64::NAN);
        let surface = sampler.pdf(&channels, f64::INFINITY);
        let pdf_integral = surface.map(|surface| surface + integrate(&inside, 0.0, length, &[]).value);
        Self { claims, pdf_integral }
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

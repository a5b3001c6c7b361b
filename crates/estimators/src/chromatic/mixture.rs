//! The probabilities of the channels, and the mixture of their exponential laws.

use crate::claims::{Channel, ChromaticClaims};
use crate::extinction::Cells;
use crate::parameter::{self, ParameterError};
use freepath_draws::math;
use freepath_draws::quadrature::{Integral, Panels, decays};
use freepath_draws::random::{exponential, uniform};

/// The probability of drawing each channel: given, or all alike.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Probabilities(Option<Vec<f64>>);

impl Probabilities {
    /// The given ones, not negative and of sum 1.
    pub(super) fn new(given: Option<Vec<f64>>) -> Result<Self, ParameterError> {
        let numbers = given.as_deref().unwrap_or(&[]);
        for &p in numbers {
            parameter::not_negative("channel_probabilities", p)?;
        }
        let sum: f64 = numbers.iter().sum();
        let whole = given.is_none() || (sum - 1.0).abs() <= 1e-12;
        parameter::require(whole, "channel_probabilities", sum, "of sum 1")?;
        Ok(Self(given))
    }

    /// The given ones, all positive and of sum 1.
    pub(super) fn positive(given: Option<Vec<f64>>) -> Result<Self, ParameterError> {
        for &p in given.as_deref().unwrap_or(&[]) {
            parameter::positive("channel_probabilities", p)?;
        }
        Self::new(given)
    }

    /// The given ones.
    pub(super) fn given(&self) -> Option<&[f64]> {
        self.0.as_deref()
    }

    /// The probability of channel `k` of `n`.
    #[inline(always)]
    pub(super) fn of(&self, k: usize, n: usize) -> f64 {
        match &self.0 {
            Some(given) => given[k],
            None => 1.0 / n as f64,
        }
    }

    /// All of them, for `n` channels.
    pub(super) fn all(&self, n: usize) -> Vec<f64> {
        (0..n).map(|k| self.of(k, n)).collect()
    }

    /// A channel of `n`, from one uniform.
    pub(super) fn draw(&self, n: usize, rng: &mut dyn rand::Rng) -> usize {
        let (u, mut sum, mut last) = (uniform(rng), 0.0, 0);
        for k in 0..n {
            let p = self.of(k, n);
            sum += p;
            if u < sum {
                return k;
            }
            last = if p > 0.0 { k } else { last };
        }
        last // the sum fell short of 1 by rounding
    }

    /// Refuses channels that are not homogeneous, not of one length, or not as many as the probabilities.
    pub(super) fn accepts(&self, channels: &[Channel]) -> Result<(), ParameterError> {
        parameter::require(!channels.is_empty(), "channels", 0, "at least one")?;
        let length = length(channels);
        for channel in channels {
            let cells = channel.extinction.cells();
            let flat = cells == Cells::Constant && channel.extinction.breaks().is_empty();
            parameter::require(flat, "channels", cells, "homogeneous")?;
            let own = channel.extinction.length();
            let same = (own - length).abs() <= 0.0;
            parameter::require(same, "channels", own, "of one length")?;
        }
        let (count, n) = (self.0.as_ref().map_or(channels.len(), Vec::len), channels.len());
        let must_be = format!("one for each of the {n} channels");
        parameter::require(count == n, "channel_probabilities", count, &must_be).map(|_| ())
    }
}

/// Extinction of a homogeneous channel.
#[inline(always)]
pub(super) fn sigma(channel: &Channel) -> f64 {
    channel.extinction.mu(0.0)
}

/// The length that all channels share.
pub(super) fn length(channels: &[Channel]) -> f64 {
    channels.first().map_or(0.0, |channel| channel.extinction.length())
}

/// The distance drawn from `channel`: infinity if it passes the end of the ray. A transparent channel always does.
pub(super) fn distance(channel: &Channel, rng: &mut dyn rand::Rng) -> f64 {
    let t = exponential(rng) / sigma(channel);
    if t < channel.extinction.length() { t } else { f64::INFINITY }
}

/// A channel's density at `t` before the end of the ray, or its probability of reaching it if `t` is infinite.
#[inline(always)]
pub(super) fn density(channel: &Channel, t: f64) -> f64 {
    let sigma = sigma(channel);
    if t >= f64::INFINITY {
        math::exp(-sigma * channel.extinction.length())
    } else {
        sigma * math::exp(-sigma * t)
    }
}

/// The target of the weight of a channel: its density times its albedo, or its transmittance.
#[inline(always)]
pub(super) fn contribution(channel: &Channel, t: f64) -> f64 {
    let albedo = if t >= f64::INFINITY { 1.0 } else { channel.albedo };
    albedo * density(channel, t)
}

/// The density of the mixture at `t`, 0 beyond the ray; its probability of reaching the end if `t` is infinite.
pub(super) fn pdf(channels: &[Channel], probability: &[f64], t: f64) -> f64 {
    let outside = t < 0.0 || (t >= length(channels) && t < f64::INFINITY);
    let terms = channels.iter().zip(probability);
    let sum = terms.map(|(channel, q)| if *q > 0.0 { q * density(channel, t) } else { 0.0 }).sum();
    if outside { 0.0 } else { sum }
}

/// x^2, x^4 or x^6, for `order` 0, 1 and 2.
pub(super) fn even_power(x: f64, order: usize) -> f64 {
    let square = x * x;
    [square, square * square, square * square * square][order]
}

/// Claims of a sampler whose even moments are E[w_k^p] = int density(f_k(t), t, p) dt, f_k the contribution; at the
/// surface the integrand at infinity. They are not claimed if a second moment overflows.
pub(super) fn claims(
    channels: &[Channel],
    probability: &[f64],
    density: &(dyn Fn(f64, f64, usize) -> f64 + '_),
) -> ChromaticClaims {
    let rates: Vec<f64> = channels.iter().map(sigma).collect();
    let panels = Panels::new(0.0, length(channels), &decays(length(channels), &rates));
    let moment = |channel: &Channel, t: f64, order: usize| {
        let f = contribution(channel, t);
        if f > 0.0 { density(f, t, order) } else { 0.0 }
    };
    let scatter = |c: &Channel| -> [Integral; 3] {
        panels.integrate_all(&|t| std::array::from_fn(|order| moment(c, t, order)), [0.0; 3])
    };
    let scattered: Vec<[Integral; 3]> = channels.iter().map(scatter).collect();
    let relative = |known: &Integral| if known.value > 0.0 { known.error / known.value } else { 0.0 };
    let larger = |worst: f64, error: f64| if worst < error { error } else { worst };
    let finite = |moments: &Vec<[f64; 3]>| moments.iter().all(|x| x[0].is_finite());
    let surface = |c: &Channel| std::array::from_fn(|order| moment(c, f64::INFINITY, order));
    ChromaticClaims {
        mixture: Some(probability.to_vec()),
        scatter_moments: Some(scattered.iter().map(|known| known.map(|m| m.value)).collect()).filter(finite),
        surface_moments: Some(channels.iter().map(surface).collect()).filter(finite),
        moments_error: scattered.iter().flatten().map(relative).fold(0.0, larger),
        balanced: false,
    }
}

/// The fields of a sampler that mixes all channels.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "channel_mixture")]
pub(super) struct Mixed {
    /// The probability of drawing each channel: positive, of sum 1, one for each channel; all alike if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) channel_probabilities: Option<Vec<f64>>,
}

impl From<Probabilities> for Mixed {
    fn from(probabilities: Probabilities) -> Self {
        let channel_probabilities = probabilities.0;
        Self { channel_probabilities }
    }
}

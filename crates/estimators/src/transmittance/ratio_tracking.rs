use crate::capability::{Capability, RATIO_TRACKING};
use crate::claims::TransmittanceClaims;
use crate::extinction::{Extinction, Medium};
use crate::transmittance::TransmittanceEstimator;
use crate::woodcock::{Collision, CollisionRule, Form, RateSegment, Rates, walk, walks};
use freepath_draws::quadrature::integrate_noisy;
use freepath_draws::{Draws, Streams};

/// Ratio tracking: one minus the collision probability, multiplied over the tentative collisions of delta tracking
/// (Novak, Selle and Jarosz 2014).
///
/// ```text
/// w = prod_i (1 - mu(t_i) / mu_bar),   t_i a Poisson process of rate mu_bar
/// E[w^k] = exp(-int mu_bar (1 - (1 - mu / mu_bar)^k))
/// ```
///
/// Target: mean T, for any positive mu_bar.
/// Range:  [0, 1] if mu <= mu_bar; unbounded otherwise.
/// Cost:   Poisson with the integral of mu_bar as mean.
/// Needs:  `mu`, `majorants`.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, serde::Serialize, schemars::JsonSchema,
)]
#[serde(deny_unknown_fields)]
pub struct RatioTracking {}

/// Multiplies the weight by 1 - (mu - control) / rate. Shared with residual ratio tracking.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ratio {
    /// The weight of a new walk.
    pub(crate) start: f64,
}

impl CollisionRule for Ratio {
    type State = f64;
    const DRAWS: bool = false;

    #[inline(always)]
    fn start(&self) -> f64 {
        self.start
    }

    #[inline(always)]
    fn collide(&self, weight: f64, at: Collision) -> (f64, bool) {
        (weight * (1.0 - (at.mu - at.control) * at.mfp), false)
    }

    #[inline(always)]
    fn weight(&self, weight: f64, _escaped: bool) -> f64 {
        weight
    }
}

/// E[w^k], k = 1 to 6, of a walk that starts at `start` and multiplies by r(t) = 1 - (mu - control) / rate:
/// start^k exp(int rate (r^k - 1)), by the exponential formula of Poisson processes.
pub(crate) fn moments(truth: &dyn Medium, rates: &Rates, start: f64) -> [f64; 6] {
    std::array::from_fn(|i| {
        let k = (i + 1) as f64;
        let part = |RateSegment { start: a, end: b, rate, control }| {
            let gain = |t: f64| rate * growth((truth.mu(t) - control) / rate, k);
            // where mu is the control but for rounding, the integral is nothing but that: times the slope of r^k, |r| <= 2
            let noise = 1e-15 * control.abs() * k * libm::exp2(k - 1.0) * (b - a);
            integrate_noisy(&gain, a, b, truth.breaks(), noise).value
        };
        libm::pow(start, k) * libm::exp(rates.segments().map(part).sum())
    })
}

/// (1 - x)^k - 1, with all its digits for small x.
fn growth(x: f64, k: f64) -> f64 {
    if x < 0.5 { libm::expm1(k * libm::log1p(-x)) } else { libm::pow(1.0 - x, k) - 1.0 }
}

impl TransmittanceEstimator for RatioTracking {
    fn estimate(&self, medium: &dyn Extinction, rng: &mut dyn rand::Rng) -> f64 {
        walk(&Ratio { start: 1.0 }, &Rates::of(medium.majorants()), Form::Carry, medium, rng).weight
    }

    fn estimate_block(&self, medium: &dyn Extinction, streams: &Streams, out: &mut Draws) {
        walks(&Ratio { start: 1.0 }, &Rates::of(medium.majorants()), Form::Carry, medium, streams, out);
    }

    fn claims(&self, truth: &dyn Medium) -> TransmittanceClaims {
        let rates = Rates::of(truth.majorants());
        let within = truth.majorants().shortfall(truth).is_none();
        TransmittanceClaims {
            bounded: false,
            moments: Some(moments(truth, &rates, 1.0)),
            range: within.then_some((0.0, 1.0)),
            lookups: Some(rates.depth()),
            poisson: Some(rates.depth()),
            ..TransmittanceClaims::default()
        }
    }

    fn capabilities(&self) -> Vec<Capability> {
        [RATIO_TRACKING, &[Capability::Collisions]].concat()
    }
}

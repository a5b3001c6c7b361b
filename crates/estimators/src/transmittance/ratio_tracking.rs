use crate::capability::{Capability, RATIO_TRACKING};
use crate::claims::TransmittanceClaims;
use crate::extinction::{Extinction, Medium};
use crate::transmittance::TransmittanceEstimator;
use crate::woodcock::{Collision, CollisionRule, Form, RateSegment, Rates, walk, walks};
use freepath_draws::quadrature::{Integral, Panels};
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

/// Moments of a weight.
pub(crate) struct WeightMoments {
    /// E[w^k] for k = 1 to 6.
    pub(crate) moments: [f64; 6],
    /// How far they may be off, relative to each.
    pub(crate) error: f64,
}

/// E[w^k], k = 1 to 6, of a walk that starts at `start` and multiplies by r(t) = 1 - (mu - control) / rate:
/// start^k exp(int rate (r^k - 1)), by the exponential formula of Poisson processes.
///
/// The first of these integrals is what tau says in closed form: where the two differ, quadrature missed something, and the
/// error of the others is at least as large.
pub(crate) fn moments(truth: &dyn Medium, rates: &Rates, start: f64) -> WeightMoments {
    let (features, length) = (truth.features(), truth.length());
    let mut exponents = [Integral::default(); 6];
    for RateSegment { start: a, end: b, rate, control } in rates.segments() {
        let gain = |t: f64| growth((truth.mu(t) - control) / rate).map(|growth| rate * growth);
        let parts = Panels::part(a, b, &features, length).integrate_all(&gain, rounding(control * (b - a)));
        for (exponent, part) in exponents.iter_mut().zip(parts) {
            *exponent += part;
        }
    }
    let worst =
        exponents.iter().fold(0.0, |worst, exponent| if worst < exponent.error { exponent.error } else { worst });
    let missed = (exponents[0].value - (rates.control_depth() - truth.tau(length))).abs();
    WeightMoments {
        moments: std::array::from_fn(|i| libm::pow(start, (i + 1) as f64) * libm::exp(exponents[i].value)),
        error: worst + 6.0 * (missed + truth.tau_error()),
    }
}

/// The noise of the integrals over a segment of this `control_depth`: where mu is the control but for rounding they are
/// nothing but that, times the slope of r^k, |r| <= 2.
fn rounding(control_depth: f64) -> [f64; 6] {
    std::array::from_fn(|i| 1e-15 * control_depth.abs() * (i + 1) as f64 * libm::exp2(i as f64))
}

/// (1 - x)^k - 1 for k = 1 to 6, with all digits for small x.
fn growth(x: f64) -> [f64; 6] {
    let mut growth = 0.0;
    std::array::from_fn(|_| {
        growth = growth * (1.0 - x) - x;
        growth
    })
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
        let WeightMoments { moments, error } = moments(truth, &rates, 1.0);
        TransmittanceClaims {
            bounded: false,
            moments: Some(moments),
            moments_error: error,
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

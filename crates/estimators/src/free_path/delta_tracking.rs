use crate::capability::{Capability, DELTA_TRACKING};
use crate::claims::FreePathClaims;
use crate::extinction::{Extinction, Medium};
use crate::free_path::FreePathSampler;
use crate::path::FreePath;
use crate::woodcock::{Collision, CollisionRule, Form, Rates, walk, walks};
use freepath_draws::quadrature::integrate;
use freepath_draws::{Draws, Streams};

/// Delta tracking: tentative collisions at the rate of the majorant, each real with probability mu / mu_bar
/// (Woodcock et al. 1965).
///
/// ```text
/// t += -ln(1 - u) / mu_bar;   collide if u' < mu(t) / mu_bar
/// ```
///
/// Target: the free-path law, if mu <= mu_bar everywhere; else that of min(mu, mu_bar).
/// Range:  (0, length), or infinity for an escape; weight 1.
/// Cost:   the integral of mu_bar(t) T(t) look-ups expected.
/// Needs:  `mu`, `majorants`.
#[doc(alias = "woodcock")]
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, serde::Serialize, schemars::JsonSchema,
)]
#[serde(deny_unknown_fields)]
pub struct DeltaTracking {
    /// The form of the walk at the end of a majorant's segment.
    #[serde(default)]
    pub form: Form,
}

/// Stops with probability mu / mu_bar. Shared with the transmittance estimator of the same name.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Analog {
    /// The weight of a walk that stops; an escape weighs 1.
    pub(crate) stopped: f64,
}

impl CollisionRule for Analog {
    type State = ();
    const DRAWS: bool = true;

    #[inline(always)]
    fn start(&self) {}

    #[inline(always)]
    fn collide(&self, (): (), at: Collision) -> ((), bool) {
        ((), at.u < at.mu * at.mfp)
    }

    #[inline(always)]
    fn weight(&self, (): (), escaped: bool) -> f64 {
        if escaped { 1.0 } else { self.stopped }
    }
}

/// Expected look-ups of an analog walk: the integral of mu_bar(t) T(t).
pub(crate) fn expected_lookups(truth: &dyn Medium) -> f64 {
    let majorants = truth.majorants();
    let part = |((start, end), mu_bar): ((f64, f64), &f64)| {
        mu_bar * integrate(&|t| libm::exp(-truth.tau(t)), start, end, truth.breaks()).value
    };
    majorants.segments().zip(majorants.mu_bar()).map(part).sum()
}

impl FreePathSampler for DeltaTracking {
    fn sample(&self, medium: &dyn Extinction, rng: &mut dyn rand::Rng) -> FreePath {
        walk(&Analog { stopped: 1.0 }, &Rates::of(medium.majorants()), self.form, medium, rng)
    }

    fn sample_block(&self, medium: &dyn Extinction, streams: &Streams, out: &mut Draws) {
        walks(&Analog { stopped: 1.0 }, &Rates::of(medium.majorants()), self.form, medium, streams, out);
    }

    fn claims<'a>(&'a self, truth: &'a dyn Medium) -> FreePathClaims<'a> {
        FreePathClaims { lookups: Some(expected_lookups(truth)), coleman: true, ..FreePathClaims::default() }
    }

    fn capabilities(&self) -> Vec<Capability> {
        let fresh = (self.form == Form::Restart).then_some(Capability::FreshFlights);
        DELTA_TRACKING.iter().copied().chain([Capability::Collisions]).chain(fresh).collect()
    }
}

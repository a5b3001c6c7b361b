use crate::capability::{Capability, DELTA_TRACKING};
use crate::claims::FreePathClaims;
use crate::extinction::{Extinction, Medium};
use crate::free_path::FreePathSampler;
use crate::path::FreePath;
use crate::woodcock::{Collision, CollisionRule, Form, Rates, walk, walks};
use freepath_draws::quadrature::{Integral, Panels};
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
///
/// T falls where tau grows by powers of two, which is where the panels end, whatever the scale of mu.
pub(crate) fn expected_lookups(truth: &dyn Medium) -> Integral {
    let (majorants, length) = (truth.majorants(), truth.length());
    let decay = (0..7).map(|power| truth.inverse_tau(libm::exp2(f64::from(power)))); // exp(-64) is nothing
    let mut features: Vec<f64> = truth.features().into_iter().chain(decay.filter(|&t| t < length)).collect();
    features.sort_by(f64::total_cmp);
    features.dedup();
    let mut lookups = Integral::default();
    for ((start, end), mu_bar) in majorants.segments().zip(majorants.mu_bar()) {
        let Integral { value, error } =
            Panels::part(start, end, &features, length).integrate(&|t| libm::exp(-truth.tau(t)));
        lookups += Integral { value: mu_bar * value, error: mu_bar * (error + value * truth.tau_error()) };
    }
    lookups
}

impl FreePathSampler for DeltaTracking {
    fn sample(&self, medium: &dyn Extinction, rng: &mut dyn rand::Rng) -> FreePath {
        walk(&Analog { stopped: 1.0 }, &Rates::of(medium.majorants()), self.form, medium, rng)
    }

    fn sample_block(&self, medium: &dyn Extinction, streams: &Streams, out: &mut Draws) {
        walks(&Analog { stopped: 1.0 }, &Rates::of(medium.majorants()), self.form, medium, streams, out);
    }

    fn claims<'a>(&'a self, truth: &'a dyn Medium) -> FreePathClaims<'a> {
        let Integral { value, error } = expected_lookups(truth);
        FreePathClaims { lookups: Some(value), lookups_error: error, coleman: true, ..FreePathClaims::default() }
    }

    fn capabilities(&self) -> Vec<Capability> {
        let fresh = (self.form == Form::Restart).then_some(Capability::FreshFlights);
        DELTA_TRACKING.iter().copied().chain([Capability::Collisions]).chain(fresh).collect()
    }
}

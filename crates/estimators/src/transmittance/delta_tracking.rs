use crate::capability::{Capability, DELTA_TRACKING};
use crate::claims::TransmittanceClaims;
use crate::extinction::{Extinction, Medium};
use crate::free_path::delta_tracking::{Analog, expected_lookups};
use crate::transmittance::TransmittanceEstimator;
use crate::woodcock::{Form, Rates, walk, walks};
use freepath_draws::{Draws, Streams};

/// Delta tracking as a transmittance estimator: whether a free path escapes (Woodcock et al. 1965).
///
/// ```text
/// X = 1 if the walk escapes, else 0,   E[X^k] = T
/// ```
///
/// Target: mean T, if mu <= mu_bar everywhere; else that of min(mu, mu_bar).
/// Range:  0 or 1.
/// Cost:   the integral of mu_bar(t) T(t) look-ups expected.
/// Needs:  `mu`, `majorants`.
#[doc(alias = "track_length")]
#[doc(alias = "woodcock")]
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, serde::Serialize, schemars::JsonSchema,
)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "delta_tracking_transmittance")]
pub struct DeltaTracking {
    /// The form of the walk at the end of a majorant's segment.
    #[serde(default)]
    pub form: Form,
}

const RULE: Analog = Analog { stopped: 0.0 };

impl TransmittanceEstimator for DeltaTracking {
    fn estimate(&self, medium: &dyn Extinction, rng: &mut dyn rand::Rng) -> f64 {
        walk(&RULE, &Rates::of(medium.majorants()), self.form, medium, rng).weight
    }

    fn estimate_block(&self, medium: &dyn Extinction, streams: &Streams, out: &mut Draws) {
        let rates = Rates::of(medium.majorants());
        walks(&RULE, &rates, self.form, medium, streams, out);
    }

    fn claims(&self, truth: &dyn Medium) -> TransmittanceClaims {
        let lookups = expected_lookups(truth);
        let transmittance = libm::exp(-truth.tau(truth.length()));
        TransmittanceClaims {
            moments: Some([transmittance; 6]),
            range: Some((0.0, 1.0)),
            binary: true,
            lookups: Some(lookups.value),
            lookups_error: lookups.error,
            ..TransmittanceClaims::default()
        }
    }

    fn capabilities(&self) -> Vec<Capability> {
        let fresh = (self.form == Form::Restart).then_some(Capability::FreshFlights);
        DELTA_TRACKING.iter().copied().chain([Capability::Collisions]).chain(fresh).collect()
    }
}

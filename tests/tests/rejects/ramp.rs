//! Delta tracking on a ramp that looks up at the wrong places.

use crate::path::{LENGTH, Sampler, path, whole};
use freepath_draws::random::{exponential, uniform};
use freepath_estimators::claims::FreePathClaims;
use freepath_estimators::free_path::DeltaTracking;
use freepath_estimators::medium::Linear;
use freepath_estimators::{Extinction, FreePath, FreePathSampler, Medium};
use freepath_harness::kind::Ray;
use freepath_harness::subject::Subject;
use freepath_tests::{Judgement, free_path, judgement};
use rand::Rng;

/// The optical depth of a ramp from 0.5 to 2 on a length of 2.1, and where it is reached.
const RAMP: (f64, f64) = (0.5, 1.5 / LENGTH);

fn ramp_depth(t: f64) -> f64 {
    RAMP.0 * t + 0.5 * RAMP.1 * t * t
}

/// Draws from the ramp by inversion, as many null collisions as delta tracking under 2 would have had, and looks up at uniform
/// places: only where it looks is wrong.
fn looks_anywhere(medium: &dyn Extinction, rng: &mut dyn Rng) -> FreePath {
    let t = ((RAMP.0 * RAMP.0 + 2.0 * RAMP.1 * exponential(rng)).sqrt() - RAMP.0) / RAMP.1;
    let reach = if t < LENGTH { t } else { LENGTH };
    let (mut left, mut collisions) = (2.0 * reach - ramp_depth(reach), u32::from(t < LENGTH));
    loop {
        left -= exponential(rng);
        if left < 0.0 {
            break;
        }
        medium.mu(reach * uniform(rng));
        collisions += 1;
    }
    if t < LENGTH {
        medium.mu(t);
    }
    FreePath { collisions, ..path(t) }
}

fn of_delta_tracking(truth: &dyn Medium) -> FreePathClaims<'_> {
    let lookups = DeltaTracking::default().claims(truth).lookups;
    FreePathClaims { coleman: true, lookups, ..whole() }
}

pub(crate) fn in_the_ramp() -> Judgement {
    let truth = Linear::new(RAMP.0, 2.0, LENGTH).expect("a medium");
    let sampler = Sampler { draw: looks_anywhere, claims: of_delta_tracking };
    let ray = Ray::of(&truth);
    judgement(&Subject { draws: 200_000, ..Subject::new(&free_path(&sampler, ray)) }, 5)
}

//! Subjects whose own law or mean is not what they say.

use crate::estimates::{Estimator, changed, of_estimate, of_ratio};
use crate::path::{MU, Sampler, escape, of_path, path, right, whole};
use freepath_estimators::claims::{FreePathClaims, TransmittanceClaims};
use freepath_results::Reason;
use freepath_tests::Judgement;

/// Claims to be off by design, and is off otherwise.
pub(crate) fn by_design() -> Vec<(&'static str, Reason, Judgement)> {
    let other = Sampler {
        draw: |_, rng| path(right(rng) / 1.05),
        claims: |_| FreePathClaims { own_law: Some(Box::new(|t| libm::exp(-1.1 * MU * t))), ..whole() },
    };
    let mean = Estimator {
        claims: |truth| TransmittanceClaims { own_mean: Some(1.05 * escape()), ..of_ratio(truth) },
        ..changed(|path, _| path)
    };
    let names = ["own_atom", "own_chi_square_16", "own_chi_square_64", "own_kolmogorov", "own_berk_jones"];
    let law = names.map(|name| (name, Reason::WrongLaw, of_path(&other, 400_000)));
    law.into_iter().chain([("own_mean", Reason::WrongLaw, of_estimate(&mean, 400_000))]).collect()
}

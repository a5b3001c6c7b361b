//! Walks whose rows, look-ups or collisions are wrong.

use crate::joint::{Resumed, Twice, WithAuxiliary};
use crate::path::{LENGTH, Sampler, escape, of_path, path, right, whole};
use crate::ramp::in_the_ramp;
use freepath_estimators::FreePath;
use freepath_estimators::claims::FreePathClaims;
use freepath_results::Reason;
use freepath_tests::Judgement;

pub(crate) fn walks() -> Vec<(&'static str, Reason, Judgement)> {
    let twice = Sampler {
        draw: |_, rng| FreePath { collisions: 2, ..path(right(rng)) },
        claims: |_| FreePathClaims { coleman: true, ..whole() },
    };
    let looks = Sampler {
        draw: |medium, rng| {
            let t = right(rng);
            for _ in 0..2 * u32::from(t < LENGTH) {
                medium.mu(t);
            }
            path(t)
        },
        claims: |_| FreePathClaims { lookups: Some(1.0 - escape()), ..whole() },
    };
    vec![
        ("lag_1", Reason::Dependent, of_path(&Twice { lag: 1, fold: |u| 1.0 - u }, 200_000)),
        ("lag_2_to_8", Reason::Dependent, of_path(&Twice { lag: 3, fold: |u| 1.0 - u }, 200_000)),
        ("pairs_16", Reason::Dependent, of_path(&Twice { lag: 1, fold: |u| (1.0 - 2.0 * u).abs() }, 200_000)),
        ("null_positions", Reason::WrongLaw, in_the_ramp()),
        ("series", Reason::WrongLaw, of_path(&Resumed::default(), 100_000)),
        (
            "auxiliary",
            Reason::Dependent,
            of_path(&WithAuxiliary(|t, u| if u < 0.1 && t < 0.3 { 5.0 * u } else { u }), 200_000),
        ),
        ("coleman", Reason::WrongLaw, of_path(&twice, 200_000)),
        ("lookups", Reason::WrongCost, of_path(&looks, 400_000)),
    ]
}

//! Distances of a wrong law.

use crate::joint::Stratified;
use crate::path::{Draw, MU, collided, escape, of_path, of_rows_that_depend, path, right, sampler};
use freepath_draws::random::uniform;
use freepath_estimators::FreePath;
use freepath_results::Reason;
use freepath_tests::Judgement;

type Found = (&'static str, Reason, Judgement);

const DRAWS: u64 = 200_000;

fn law(draw: Draw) -> Judgement {
    of_path(&sampler(draw), DRAWS)
}

pub(crate) fn laws() -> Vec<Found> {
    wide().into_iter().chain(narrow()).collect()
}

/// What is wrong over a good part of the ray.
fn wide() -> Vec<Found> {
    let atom =
        law(|_, rng| FreePath::at(if uniform(rng) < 0.9 * escape() { f64::INFINITY } else { collided(rng) }));
    let lobe = law(|_, rng| {
        let t = right(rng);
        path(if (0.4..0.5).contains(&t) && uniform(rng) < 0.2 { t + 0.3 } else { t })
    });
    let narrow = law(|_, rng| {
        let t = right(rng);
        path(if (0.40..0.41).contains(&t) && uniform(rng) < 0.5 { t + 0.02 } else { t })
    });
    let needle = law(|_, rng| {
        let t = right(rng);
        path(if (0.400..0.402).contains(&t) { t + 0.01 } else { t })
    });
    let thin = || law(|_, rng| path(right(rng) / 0.97));
    let thicker = law(|_, rng| path(right(rng) / 1.02));
    let wave = law(|_, rng| {
        let u = uniform(rng);
        let bent = u + 0.004 * freepath_draws::math::sin2pi(3.0 * u);
        path(-libm::log1p(-bent * (1.0 - 1e-12)) / MU)
    });
    vec![
        ("atom", Reason::WrongLaw, atom),
        ("chi_square_16", Reason::WrongLaw, lobe),
        ("chi_square_64", Reason::WrongLaw, narrow),
        ("chi_square_fine", Reason::WrongLaw, needle),
        ("kolmogorov", Reason::WrongLaw, thin()),
        ("anderson_darling", Reason::WrongLaw, thin()),
        ("cramer_von_mises", Reason::WrongLaw, thin()),
        ("kuiper", Reason::WrongLaw, thin()),
        ("exposure", Reason::WrongLaw, thicker),
        ("neyman_16", Reason::WrongLaw, wave),
        ("whole_law", Reason::WrongLaw, thin()),
    ]
}

/// What is wrong at one place, or in how the rows hang together.
fn narrow() -> Vec<Found> {
    let hot = law(|_, rng| path(if uniform(rng) < 3e-4 { 1e-6 * uniform(rng) } else { right(rng) }));
    let gap = law(|_, rng| {
        let t = right(rng);
        path(if (0.8..0.8008).contains(&t) { t + 0.7 } else { t })
    });
    let late = law(|_, rng| {
        let t = right(rng);
        path(if t < 2e-4 { t + 2e-4 } else { t })
    });
    let even = of_path(&Stratified, DRAWS);
    let shifted = of_rows_that_depend(&sampler(|_, rng| path(right(rng) / 0.9)), DRAWS);
    let repeated = law(|_, rng| path(if uniform(rng) < 3e-4 { 0.25 } else { right(rng) }));
    vec![
        ("berk_jones", Reason::WrongLaw, hot),
        ("scan", Reason::WrongLaw, gap),
        ("breaks", Reason::WrongLaw, late),
        ("too_even", Reason::Dependent, even),
        ("ties", Reason::Dependent, repeated),
        ("batch_shares", Reason::WrongLaw, shifted),
    ]
}

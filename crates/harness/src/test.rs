//! The tests: tallies in, [`Evidence`](crate::evidence::Evidence) out. One test per file.

use crate::{identities, scripted};

mod agree;
mod anderson_darling;
mod atom;
mod berk_jones;
mod chi_square;
mod coleman;
mod cramer_von_mises;
mod doubt;
mod exposure;
mod family;
mod grouped;
mod kolmogorov;
mod kuiper;
mod lag;
mod lookups;
mod mark;
mod mean;
mod neyman;
mod null_positions;
mod pairs;
mod poisson_count;
mod second_moment;
mod series;
mod ties;

pub use agree::{Sample, agree_atom, agree_law, agree_mean};
pub use anderson_darling::anderson_darling;
pub use atom::atom;
pub(crate) use atom::nearest;
pub use berk_jones::{BerkJones, berk_jones};
pub use chi_square::{chi_square, detectable_cell, least_expected, residuals};
pub use coleman::coleman;
pub use cramer_von_mises::cramer_von_mises;
pub use doubt::doubt;
pub use exposure::{detectable_scale, exposure};
pub use family::{NULLS, declares, family};
pub use kolmogorov::kolmogorov;
pub(crate) use kolmogorov::larger;
pub use kuiper::kuiper;
pub use lag::{lag, lag_observed, lags};
pub use lookups::{BlockLookups, lookups};
pub use mark::mark;
pub(crate) use mean::within;
pub use mean::{Interval, MeanClaim, Method, interval_at, mean, open};
pub use neyman::neyman;
pub use null_positions::null_positions;
pub use pairs::pairs;
pub use poisson_count::poisson_count;
pub use second_moment::second_moment;
pub use series::series;
pub use ties::{pair_probability, ties};

/// Each check that finds facts, by name, with what it looks at: no p-value, and one fact fails.
pub const CHECKS: &[(&str, &str)] = &[
    ("subject", "A fact: the subject stopped, panicked, ran past its budget or spoilt its block of draws."),
    ("audit", "A fact: a look-up above the majorant of a subject that relies on the bound, or outside the ray."),
    ("finite", "A fact: a draw is NaN, or infinite where it may not be."),
    ("support", "A fact: a distance lies outside the ray."),
    ("vacuum", "A fact: a collision lies where mu is 0."),
    ("unit_weight", "A fact: a draw of a free path has a weight other than 1."),
    (scripted::CHECK, scripted::WORDS),
    identities::CHECKS[0],
    identities::CHECKS[1],
    identities::CHECKS[2],
    identities::CHECKS[3],
    identities::CHECKS[4],
    identities::CHECKS[5],
    identities::CHECKS[6],
    identities::CHECKS[7],
    identities::CHECKS[8],
];

/// Each test by name, with what it looks at.
pub const NAMES: &[(&str, &str)] = &[
    ("atom", atom::WORDS),
    ("chi_square_16", chi_square::WORDS),
    ("chi_square_64", chi_square::WORDS),
    ("chi_square_fine", chi_square::WORDS),
    ("kolmogorov", kolmogorov::WORDS),
    ("exposure", exposure::WORDS),
    ("neyman_16", neyman::WORDS),
    ("anderson_darling", anderson_darling::WORDS),
    ("cramer_von_mises", cramer_von_mises::WORDS),
    ("kuiper", kuiper::WORDS),
    ("berk_jones", berk_jones::WORDS),
    ("coleman", coleman::WORDS),
    ("poisson_count", poisson_count::WORDS),
    ("ties", ties::WORDS),
    ("lag_1", lag::WORDS),
    ("lag_2_to_8", lag::FURTHER),
    ("pairs_16", pairs::WORDS),
    ("null_positions", null_positions::WORDS),
    ("series", series::WORDS),
    ("mark", mark::WORDS),
    ("mean", mean::WORDS),
    (
        "growth",
        "While draws double towards a `bias_bound`: the mean or the law against its truth, at all numbers of draws at once (bets, empirical Bernstein and beta-binomial mixtures, or Dvoretzky-Kiefer-Wolfowitz at each look).",
    ),
    ("second_moment", second_moment::WORDS),
    ("lookups", lookups::WORDS),
    agree::WORDS[0],
    agree::WORDS[1],
    agree::WORDS[2],
    agree::WORDS[3],
    (
        "pdf_integral",
        "The density that a chromatic sampler returns, integrated over the ray, plus its probability of reaching the surface, is 1: an identity without noise.",
    ),
];

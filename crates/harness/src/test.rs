//! The tests: tallies in, [`Evidence`](crate::evidence::Evidence) out. One test per file.

mod anderson_darling;
mod atom;
mod berk_jones;
mod chi_square;
mod coleman;
mod cramer_von_mises;
mod grouped;
mod kolmogorov;
mod kuiper;
mod lag;
mod lookups;
mod mean;
mod poisson_count;
mod second_moment;
mod ties;

pub use anderson_darling::anderson_darling;
pub use atom::atom;
pub use berk_jones::{BerkJones, berk_jones};
pub use chi_square::{chi_square, residuals};
pub use coleman::coleman;
pub use cramer_von_mises::cramer_von_mises;
pub use kolmogorov::kolmogorov;
pub(crate) use kolmogorov::larger;
pub use kuiper::kuiper;
pub use lag::lag;
pub use lookups::{BlockLookups, lookups};
pub(crate) use mean::bernstein_width;
pub use mean::{Interval, MeanClaim, Method, mean};
pub use poisson_count::poisson_count;
pub use second_moment::second_moment;
pub use ties::{pair_probability, ties};

/// Each test by name, with what it looks at.
pub const NAMES: &[(&str, &str)] = &[
    ("atom", atom::WORDS),
    ("chi_square_16", chi_square::WORDS),
    ("chi_square_64", chi_square::WORDS),
    ("chi_square_fine", chi_square::WORDS),
    ("kolmogorov", kolmogorov::WORDS),
    ("anderson_darling", anderson_darling::WORDS),
    ("cramer_von_mises", cramer_von_mises::WORDS),
    ("kuiper", kuiper::WORDS),
    ("berk_jones", berk_jones::WORDS),
    ("coleman", coleman::WORDS),
    ("poisson_count", poisson_count::WORDS),
    ("ties", ties::WORDS),
    ("lag_1", lag::WORDS),
    ("mean", mean::WORDS),
    ("second_moment", second_moment::WORDS),
    ("lookups", lookups::WORDS),
    (
        "pdf_integral",
        "The density that a chromatic sampler returns, integrated over the ray, plus its probability of reaching the surface, is 1: an identity without noise.",
    ),
    ("bound", "A fact, not a p-value: one look-up above the majorant fails a subject that relies on the bound."),
];

//! The tests: tallies in, [`Evidence`](crate::evidence::Evidence) out. One test per file.

mod atom;
mod chi_square;
mod coleman;
mod exposure;
mod kolmogorov;
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

pub use atom::atom;
pub use chi_square::{chi_square, detectable_cell, residuals};
pub use coleman::coleman;
pub use exposure::{detectable_scale, exposure};
pub use kolmogorov::kolmogorov;
pub(crate) use kolmogorov::larger;
pub use lag::{lag, lags};
pub use lookups::{BlockLookups, lookups};
pub use mark::mark;
pub(crate) use mean::bernstein_width;
pub use mean::{Interval, MeanClaim, Method, mean};
pub use neyman::neyman;
pub use null_positions::null_positions;
pub use pairs::pairs;
pub use poisson_count::poisson_count;
pub use second_moment::second_moment;
pub use series::series;
pub use ties::{pair_probability, ties};

/// Each test by name, with what it looks at.
pub const NAMES: &[(&str, &str)] = &[
    ("atom", atom::WORDS),
    ("chi_square_16", chi_square::WORDS),
    ("chi_square_64", chi_square::WORDS),
    ("chi_square_fine", chi_square::WORDS),
    ("kolmogorov", kolmogorov::WORDS),
    ("exposure", exposure::WORDS),
    ("neyman_16", neyman::WORDS),
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
    ("second_moment", second_moment::WORDS),
    ("lookups", lookups::WORDS),
    (
        "pdf_integral",
        "The density that a chromatic sampler returns, integrated over the ray, plus its probability of reaching the surface, is 1: an identity without noise.",
    ),
    ("bound", "A fact, not a p-value: one look-up above the majorant fails a subject that relies on the bound."),
];

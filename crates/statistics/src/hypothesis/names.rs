use super::{
    agree, anderson_darling, atom, berk_jones, chi_square, coleman, cramer_von_mises, exposure, kolmogorov,
    kuiper, lag, lookups, mark, mean, neyman, null_positions, pairs, poisson_count, second_moment, series, ties,
};

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

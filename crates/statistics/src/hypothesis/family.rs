use super::names::NAMES;

/// Which laws the p-values of each test may have where its claim holds, by [`Null::name`](crate::evidence::Null::name).
///
/// A test that gives facts and no p-values has none.
const NULLS: &[(&str, &[&str])] = &[
    ("atom", &["discrete"]),
    ("chi_square_16", &["uniform"]),
    ("chi_square_64", &["uniform"]),
    ("chi_square_fine", &["uniform"]),
    ("kolmogorov", &["conservative"]),
    ("anderson_darling", &["uniform"]),
    ("cramer_von_mises", &["uniform"]),
    ("kuiper", &["uniform"]),
    ("berk_jones", &["conservative"]),
    ("exposure", &["uniform"]),
    ("neyman_16", &["uniform", "conservative"]),
    ("coleman", &["uniform"]),
    ("poisson_count", &["uniform"]),
    ("ties", &["conservative"]),
    ("lag_1", &["uniform"]),
    ("lag_2_to_8", &["uniform"]),
    ("pairs_16", &["uniform"]),
    ("null_positions", &["uniform"]),
    ("series", &["conservative"]),
    ("mark", &["uniform"]),
    ("mean", &["uniform", "discrete", "conservative"]),
    ("growth", &["conservative"]),
    ("second_moment", &["uniform", "conservative"]),
    ("lookups", &["uniform", "conservative"]),
    ("agree_majorant", AGREE),
    ("agree_segments", AGREE),
    ("agree_grid", AGREE),
    ("agree_reversed", AGREE),
    ("pdf_integral", &["conservative"]),
];

/// Of means that skewness allows; exact, of laws and bounded.
const AGREE: &[&str] = &["uniform", "conservative"];

/// The name in [`NAMES`] of the test that a piece of evidence comes from: `own_atom` is an `atom`, `scatter_0_bin_3` a
/// `mean`.
#[must_use]
pub fn family(name: &str) -> &str {
    let name = name.strip_prefix("own_").unwrap_or(name);
    match () {
        () if NAMES.iter().any(|(known, _)| *known == name) => name,
        () if name.starts_with("second_moment_") => "second_moment",
        () if name.starts_with("scatter_") || name.starts_with("surface_") => "mean",
        () => name,
    }
}

/// Whether the p-values of test `family` may follow the law of this name.
#[must_use]
pub fn declares(family: &str, null: &str) -> bool {
    NULLS.iter().any(|(name, nulls)| *name == family && nulls.contains(&null))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_test_says_how_its_p_values_are_distributed() {
        let facts = ["bound"];
        for (name, _) in NAMES.iter().filter(|(name, _)| !facts.contains(name)) {
            assert!(NULLS.iter().any(|(known, _)| known == name), "{name} is not in NULLS");
        }
        assert!(NULLS.iter().all(|(known, _)| NAMES.iter().any(|(name, _)| name == known)));
    }

    #[test]
    fn every_claim_belongs_to_a_test() {
        let of = ["own_atom", "scatter_0_bin_3", "surface_2", "second_moment_scatter_1", "chi_square_16"];
        let to = ["atom", "mean", "mean", "second_moment", "chi_square_16"];
        assert_eq!(of.map(family), to);
    }
}

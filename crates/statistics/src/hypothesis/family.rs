use super::list::TESTS;
use super::record::Test;
use crate::evidence::{Alone, NullClass};

/// The test of this name.
fn test(name: &str) -> Option<&'static Test> {
    TESTS.iter().find(|test| test.name == name)
}

/// The prefixes of the same tests of other numbers than those of the main law: of the law that a method has by design,
/// of the second rank of a row, of both ranks at once, of another file, of the trials of a draw, of the length of a walk.
const PREFIXES: [&str; 6] = ["own_", "second_rank_", "joint_", "other_", "trials_", "length_"];

/// The name in [`TESTS`] of the test that a piece of evidence comes from: `own_atom` is an `atom`, `scatter_0_bin_3` a
/// `mean`.
#[must_use]
pub fn family(name: &str) -> &str {
    let name = PREFIXES.iter().find_map(|prefix| name.strip_prefix(prefix)).unwrap_or(name);
    let name = of_channel(name).unwrap_or(name);
    if test(name).is_some() {
        name
    } else if name.starts_with("atom_") {
        "atom"
    } else if name.starts_with("bounded_mean_") {
        "bounded_mean"
    } else if name.starts_with("second_moment_") {
        "second_moment"
    } else if name.starts_with("scatter_") || name.starts_with("surface_") {
        "mean"
    } else {
        name
    }
}

/// The test of the weights of a channel: `channel_0_order` is an `order`.
fn of_channel(name: &str) -> Option<&str> {
    let rest = name.strip_prefix("channel_")?.trim_start_matches(|c: char| c.is_ascii_digit());
    rest.strip_prefix('_')
}

/// True if the p-values of test `family` may follow a law of this class.
#[must_use]
pub fn declares(family: &str, null: NullClass) -> bool {
    test(family).is_some_and(|test| test.nulls.contains(&null))
}

/// True if test `family` may reject in one stage alone.
#[must_use]
pub fn may_reject_alone(family: &str) -> bool {
    test(family).is_some_and(|test| match test.alone {
        Alone::Exact | Alone::Proven | Alone::Measured => true,
        Alone::No => false,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_claim_belongs_to_a_test() {
        let of =
            ["own_atom", "scatter_0_bin_3", "surface_2", "second_moment_scatter_1", "chi_square_16", "atom_1"];
        let to = ["atom", "mean", "mean", "second_moment", "chi_square_16", "atom"];
        assert_eq!(of.map(family), to);
        assert_eq!(["channel_0_order", "channel_12_along_escapes"].map(family), ["order", "along_escapes"]);
        assert_eq!(["channel_0_weighted_16", "channel_2_weighted_64"].map(family), ["weighted_16", "weighted_64"]);
        assert_eq!(
            ["second_rank_kuiper", "joint_chi_square_64", "trials_count_law"].map(family),
            ["kuiper", "chi_square_64", "count_law"]
        );
    }

    #[test]
    fn a_limit_law_that_nobody_measured_rejects_nothing_alone() {
        assert!(["atom", "berk_jones", "chi_square_64"].into_iter().all(may_reject_alone));
        assert!(!["exposure", "neyman_16", "pairs_16", "lookups", "unheard_of"].into_iter().any(may_reject_alone));
    }
}

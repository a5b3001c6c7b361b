//! The list of the checks that find facts. A test has a list beside it, in `freepath_statistics`; `docs/statistics.md` has a
//! section for each of both.

use crate::identities::{
    composition, counts, density, envelope, history, inverse, medium, reproducible, roulette, support, table,
    zero_variance,
};
use crate::scripted;
use freepath_statistics::check::{self, Check};

/// Every check, in the order in which they are told: no p-value, and one fact fails.
pub const CHECKS: &[Check] = &[
    check::SUBJECT,
    check::AUDIT,
    check::FINITE,
    check::SUPPORT,
    check::RANGE,
    check::NOISE_FREE,
    check::BINARY,
    check::EQUAL_BLOCKS,
    check::REPEATS,
    check::SORTED,
    check::VACUUM,
    check::UNIT_WEIGHT,
    scripted::CHECK,
    reproducible::CHECK,
    history::CHECK,
    reproducible::STREAMS,
    medium::CHECK,
    composition::CHECK,
    roulette::CHECK,
    zero_variance::CHECK,
    counts::CHECK,
    check::WEIGHT_IDENTITY,
    density::CHECK,
    support::CHECK,
    table::CHECK,
    inverse::CHECK,
    envelope::CHECK,
];

#[cfg(test)]
mod guard {
    use super::CHECKS;
    use freepath_statistics::hypothesis::TESTS;
    use std::fs;
    use std::path::Path;

    #[test]
    fn every_record_is_whole_and_its_name_is_its_own() {
        let names: Vec<_> =
            TESTS.iter().map(|test| test.name).chain(CHECKS.iter().map(|check| check.name)).collect();
        let twice: Vec<_> =
            names.iter().filter(|name| names.iter().filter(|other| other == name).count() > 1).collect();
        assert!(twice.is_empty(), "two records are called {twice:?}");
        let empty: Vec<_> =
            CHECKS.iter().filter(|check| check.words.is_empty() || check.details.is_empty()).collect();
        assert!(empty.is_empty(), "no words or details: {empty:?}");
    }

    #[test]
    fn every_check_of_the_identities_is_in_the_list() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/identities");
        let named = |text: &str| -> Vec<String> {
            let after = text.split("    name: \"").skip(1);
            after.map(|rest| rest.split('"').next().unwrap_or(rest).to_string()).collect()
        };
        let files = fs::read_dir(folder).unwrap().map(|entry| fs::read_to_string(entry.unwrap().path()).unwrap());
        let all: Vec<String> = files.flat_map(|text| named(&text)).collect();
        assert!(all.len() > 8, "{all:?}");
        let missing: Vec<_> = all.iter().filter(|name| !CHECKS.iter().any(|check| check.name == **name)).collect();
        assert!(missing.is_empty(), "not in CHECKS of describe.rs: {missing:?}");
    }
}

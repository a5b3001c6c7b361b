//! Tests and checks in short: what `freepath describe` prints below the first sentence. `docs/statistics.md` has the
//! long form, a section for each name.

mod checks;
mod tests;

pub use checks::CHECKS;

/// Formula, gate and source of a test of [`NAMES`](freepath_statistics::hypothesis::NAMES), or what a check of [`CHECKS`] compares with what.
#[must_use]
pub fn details(name: &str) -> Option<&'static str> {
    let all = tests::DETAILS.iter().chain(checks::DETAILS);
    all.copied().find(|(known, _)| *known == name).map(|(_, words)| words)
}

#[cfg(test)]
mod guard {
    use super::{checks, details, tests};
    use crate::describe::CHECKS;
    use freepath_statistics::hypothesis::NAMES;

    #[test]
    fn everything_that_has_a_name_has_details_and_nothing_else_has() {
        let known: Vec<&str> = NAMES.iter().chain(CHECKS).map(|(name, _)| *name).collect();
        let missing: Vec<_> = known.iter().filter(|name| details(name).is_none()).collect();
        assert!(missing.is_empty(), "no details of {missing:?}");
        let told: Vec<&str> = tests::DETAILS.iter().chain(checks::DETAILS).map(|(name, _)| *name).collect();
        assert_eq!(told.len(), known.len(), "a name is told twice: {told:?}");
        let unknown: Vec<_> = told.iter().filter(|name| !known.contains(name)).collect();
        assert!(unknown.is_empty(), "details of {unknown:?}, which nobody knows");
    }
}

//! Tests, checks and reasons in short: what `freepath describe` prints below the first sentence. `docs/statistics.md` has the
//! long form, a section for each name.

mod checks;
mod reasons;
mod tests;

use crate::verdict::Reason;

/// Formula, gate and source of a test of [`NAMES`](crate::test::NAMES), or what a check compares with what.
#[must_use]
pub fn details(name: &str) -> Option<&'static str> {
    let all = tests::DETAILS.iter().chain(checks::DETAILS);
    all.copied().find(|(known, _)| *known == name).map(|(_, words)| words)
}

/// What gives a reason, what usually causes it, and what to do.
#[must_use]
pub fn advice(reason: Reason) -> &'static str {
    reasons::ADVICE.iter().find(|(known, _)| *known == reason).map_or("", |(_, words)| words)
}

#[cfg(test)]
mod guard {
    use super::{advice, checks, details, tests};
    use crate::test::{CHECKS, NAMES};
    use crate::verdict::Reason;

    #[test]
    fn everything_that_has_a_name_has_details_and_nothing_else_has() {
        let known: Vec<&str> = NAMES.iter().chain(CHECKS).map(|(name, _)| *name).collect();
        let missing: Vec<_> = known.iter().filter(|name| details(name).is_none()).collect();
        assert!(missing.is_empty(), "no details of {missing:?}");
        let told: Vec<&str> = tests::DETAILS.iter().chain(checks::DETAILS).map(|(name, _)| *name).collect();
        assert_eq!(told.len(), known.len(), "a name is told twice: {told:?}");
        let unknown: Vec<_> = told.iter().filter(|name| !known.contains(name)).collect();
        assert!(unknown.is_empty(), "details of {unknown:?}, which nobody knows");
        assert!(Reason::ALL.iter().all(|reason| !advice(*reason).is_empty()));
    }
}

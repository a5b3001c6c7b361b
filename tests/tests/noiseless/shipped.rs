//! The shipped cases: nothing is wrong with a subject that carries no fault and is not stated to fail.

use freepath_harness::case::{Limits, PreparedSubject};
use freepath_harness::fault::Expectation;
use freepath_harness::noiseless::facts;
use freepath_tests::{case_paths, load};

#[test]
fn nothing_is_found_in_the_shipped_cases() {
    for path in case_paths("cases") {
        for case in load(&path, &Limits::default()) {
            let right = |prepared: &&PreparedSubject| {
                prepared.faults.is_empty() && !matches!(prepared.spec.expect, Some(Expectation::Fail(_)))
            };
            for prepared in case.subjects.iter().filter(right) {
                let subject = prepared.runnable(&case.case);
                let facts = facts(&subject, &subject.plan(), 1);
                assert!(facts.is_empty(), "{}: {}: {facts:?}", path.display(), prepared.name);
            }
        }
    }
}

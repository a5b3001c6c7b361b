//! The shipped cases, in which nothing is wrong.

use freepath_harness::case::Limits;
use freepath_harness::noiseless::facts;
use freepath_tests::{case_paths, load};

#[test]
fn nothing_is_found_in_the_shipped_cases() {
    for path in case_paths("cases") {
        for case in load(&path, &Limits::default()) {
            for prepared in case.subjects.iter().filter(|prepared| prepared.faults.is_empty()) {
                let subject = prepared.runnable(&case.case);
                let facts = facts(&subject, &subject.plan(), 1);
                assert!(facts.is_empty(), "{}: {}: {facts:?}", path.display(), prepared.name);
            }
        }
    }
}

//! Planted faults, and what became of them.

use super::matrix::Letter;
use super::table::evidence;
use crate::site::Site;
use crate::text::{clean, words};
use freepath_results::{SubjectResult, Verdict};

/// One planted fault and what became of it.
pub(crate) struct ControlRow {
    pub(crate) letter: Letter,
    pub(crate) fault: String,
    pub(crate) subject: String,
    pub(crate) case: String,
    pub(crate) reasons: String,
    pub(crate) evidence: String,
    pub(crate) outcome: &'static str,
}

/// A fault that its setting hides, or that does no harm, must pass.
fn outcome(result: &SubjectResult) -> &'static str {
    match (result.as_expected, result.verdict, result.masks_fault) {
        (false, ..) => "not as expected",
        (true, Verdict::Pass, true) => "hidden, as it must be",
        (true, Verdict::Pass, false) => "harmless, and passes",
        (true, ..) => "caught",
    }
}

pub(crate) fn rows(site: &Site) -> Vec<ControlRow> {
    let controls = site.subjects.iter().filter(|s| s.is_control());
    controls
        .map(|s| ControlRow {
            letter: Letter::new(s),
            fault: clean(&words(&s.result.faults.join(" + ")), 120),
            subject: s.name.clone(),
            case: site.cases[s.case].title.clone(),
            reasons: super::table::reasons(s.result),
            evidence: evidence(s.result),
            outcome: outcome(s.result),
        })
        .collect()
}

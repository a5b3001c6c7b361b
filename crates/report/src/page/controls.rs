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
    if !result.as_expected {
        return "not as expected";
    }
    match result.verdict {
        Verdict::Pass if result.masks_fault => "hidden, as it must be",
        Verdict::Pass => "harmless, and passes",
        Verdict::Inconclusive | Verdict::Fail => "caught",
    }
}

pub(crate) fn rows(site: &Site) -> Vec<ControlRow> {
    let mut controls: Vec<_> = site.subjects.iter().filter(|s| s.is_control()).collect();
    controls.sort_by_key(|s| s.result.as_expected);
    let controls = controls.into_iter();
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

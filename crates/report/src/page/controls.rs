//! Planted faults, each of which must be caught.

use super::matrix::Letter;
use super::table::evidence;
use crate::site::Site;
use crate::text::{clean, words};

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
            outcome: if s.result.as_expected { "caught" } else { "not as expected" },
        })
        .collect()
}

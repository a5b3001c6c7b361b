//! All that is not as expected, in one list above everything else.

use super::table::reasons;
use crate::site::{Site, Subject, title};
use crate::text::{clean, words};
use freepath_results::SubjectResult;

/// The list: nothing is ever left out of it.
pub(crate) struct Attention {
    pub(crate) entries: Vec<Entry>,
    /// The number of them that have no section.
    pub(crate) beyond: usize,
}

/// One subject in one sentence.
pub(crate) struct Entry {
    /// Its section, if it has one.
    pub(crate) anchor: String,
    /// Its id in results.json, if it has none.
    pub(crate) id: String,
    pub(crate) subject: String,
    pub(crate) case: String,
    pub(crate) verdict: String,
    pub(crate) reasons: String,
    pub(crate) expected: String,
}

impl Attention {
    pub(crate) fn new(site: &Site) -> Self {
        let with_section = site.subjects.iter().filter(|s| !s.result.as_expected).map(|s| linked(site, s));
        let without = site.beyond.iter().map(|result| unlinked(site, result));
        Self { entries: with_section.chain(without).collect(), beyond: site.beyond.len() }
    }
}

fn linked(site: &Site, subject: &Subject) -> Entry {
    let case = site.cases[subject.case].title.clone();
    Entry { anchor: subject.id.clone(), ..entry(subject.result, case) }
}

fn unlinked(site: &Site, result: &SubjectResult) -> Entry {
    let case = site.results.media.get(result.medium).map_or_else(|| clean(&result.case, 200), title);
    Entry { id: clean(&result.id, 300), ..entry(result, case) }
}

fn entry(result: &SubjectResult, case: String) -> Entry {
    Entry {
        anchor: String::new(),
        id: String::new(),
        subject: clean(&result.subject, 80),
        case,
        verdict: result.verdict.to_string(),
        reasons: reasons(result),
        expected: clean(&words(&result.expected), 80),
    }
}

//! The results with an address for each part, and in the order of the page.

use crate::SideFiles;
use crate::text::{Slugs, clean};
use freepath_results::{MediumResult, Results, SubjectResult, Timings};
use std::collections::HashMap;

/// Most subjects that a page shows.
pub(crate) const MOST_SUBJECTS: usize = 2000;

/// Everything that a report shows.
pub(crate) struct Site<'a> {
    pub(crate) results: &'a Results,
    pub(crate) timings: Option<&'a Timings>,
    pub(crate) side_files: &'a SideFiles,
    pub(crate) subjects: Vec<Subject<'a>>,
    pub(crate) cases: Vec<Case<'a>>,
}

/// One subject of the results.
pub(crate) struct Subject<'a> {
    /// The anchor, and the start of the names of its plots.
    pub(crate) id: String,
    /// Its name, fit for display.
    pub(crate) name: String,
    pub(crate) result: &'a SubjectResult,
    /// Seconds for one draw, if timed.
    pub(crate) seconds: Option<f64>,
    /// What it wrote to standard error, if it is a program.
    pub(crate) log: &'a str,
    /// Index into [`Site::cases`].
    pub(crate) case: usize,
}

impl Subject<'_> {
    /// A planted fault, which must be caught.
    pub(crate) fn is_control(&self) -> bool {
        !self.result.faults.is_empty()
    }
}

/// One medium along one ray, with the subjects that met it.
pub(crate) struct Case<'a> {
    pub(crate) id: String,
    pub(crate) title: String,
    pub(crate) medium: Option<&'a MediumResult>,
    /// Indices into [`Site::subjects`].
    pub(crate) members: Vec<usize>,
}

impl<'a> Site<'a> {
    pub(crate) fn new(results: &'a Results, timings: Option<&'a Timings>, side_files: &'a SideFiles) -> Self {
        let mut slugs = Slugs::default();
        let mut cases: Vec<Case> = results.media.iter().take(MOST_SUBJECTS).map(|m| case(m, &mut slugs)).collect();
        let (seconds, logs) = (per_draw(timings), logs(timings));
        let mut orphans = false;
        let mut subjects = vec![];
        for result in results.results.iter().take(MOST_SUBJECTS) {
            let home =
                if result.medium < cases.len() { result.medium } else { cases.len() - usize::from(orphans) };
            if home == cases.len() {
                cases.push(lost(&mut slugs));
                orphans = true;
            }
            cases[home].members.push(subjects.len());
            subjects.push(Subject {
                id: slugs.take("s-", &result.id),
                name: clean(&result.subject, 80),
                result,
                seconds: seconds.get(result.id.as_str()).copied(),
                log: logs.get(result.id.as_str()).copied().unwrap_or(""),
                case: home,
            });
        }
        Self { results, timings, side_files, subjects, cases }
    }

    /// The subjects of a case.
    pub(crate) fn members(&self, case: &Case) -> Vec<&Subject<'a>> {
        case.members.iter().filter_map(|&i| self.subjects.get(i)).collect()
    }

    /// The subject of this id in the results.
    pub(crate) fn find(&self, id: &str) -> Option<&Subject<'a>> {
        self.subjects.iter().find(|subject| subject.result.id == id)
    }

    /// How many subjects are not shown.
    pub(crate) fn left_out(&self) -> usize {
        self.results.results.len() - self.subjects.len()
    }
}

fn case<'a>(medium: &'a MediumResult, slugs: &mut Slugs) -> Case<'a> {
    let ray = medium.ray.map_or(String::new(), |ray| format!(", ray {ray}"));
    let title = format!("{}{ray}", clean(&medium.case, 200));
    Case { id: slugs.take("c-", &title), title, medium: Some(medium), members: vec![] }
}

/// For subjects whose medium the results do not hold.
fn lost<'a>(slugs: &mut Slugs) -> Case<'a> {
    let title = "Medium not in the results".to_string();
    Case { id: slugs.take("c-", &title), title, medium: None, members: vec![] }
}

fn logs(timings: Option<&Timings>) -> HashMap<&str, &str> {
    timings.iter().flat_map(|t| &t.subjects).map(|s| (s.id.as_str(), s.log.as_str())).collect()
}

fn per_draw(timings: Option<&Timings>) -> HashMap<&str, f64> {
    let all = timings.iter().flat_map(|t| &t.subjects).filter(|s| s.draws > 0);
    all.map(|s| (s.id.as_str(), s.seconds.0 / s.draws as f64)).collect()
}

//! The results with an address for each part, and in the order of the page.

use crate::SideFiles;
use crate::shown::at_most;
use crate::text::{Slugs, clean, words};
use freepath_results::{MediumResult, Results, SubjectResult, Timings};
use std::collections::{HashMap, HashSet};

/// Most subjects, and most media, that have a section of their own.
pub(crate) const MOST_SECTIONS: usize = 2000;

/// Everything that a report shows.
pub(crate) struct Site<'a> {
    pub(crate) results: &'a Results,
    pub(crate) timings: Option<&'a Timings>,
    pub(crate) side_files: &'a SideFiles,
    /// Those with a section, in the order of the results: what is not as expected goes before what is.
    pub(crate) subjects: Vec<Subject<'a>>,
    /// Those not as expected for which no section was left.
    pub(crate) beyond: Vec<&'a SubjectResult>,
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
    /// Its output on standard error, if it is a program.
    pub(crate) log: &'a str,
    /// Index into [`Site::cases`].
    pub(crate) case: usize,
    /// True if it draws along a ray: other scenes have neither escapes nor look-ups of mu.
    pub(crate) on_ray: bool,
}

impl Subject<'_> {
    /// A planted fault, which must be caught.
    pub(crate) fn is_control(&self) -> bool {
        !self.result.faults.is_empty()
    }

    /// Look-ups per draw, where they are known.
    pub(crate) fn lookups(&self) -> Option<f64> {
        let elsewhere = matches!(self.result.estimator.as_str(), "samples" | "command");
        (!elsewhere).then_some(self.result.lookups.0)
    }
}

/// One medium along one ray, with the subjects that met it.
pub(crate) struct Case<'a> {
    pub(crate) id: String,
    /// Its number in the results, from 1.
    pub(crate) number: usize,
    pub(crate) title: String,
    pub(crate) medium: Option<&'a MediumResult>,
    /// Indices into [`Site::subjects`].
    pub(crate) members: Vec<usize>,
}

/// True of a medium along a ray: other scenes have neither extinction nor length.
pub(crate) fn is_ray(medium: &MediumResult) -> bool {
    !medium.series.is_empty()
}

impl<'a> Site<'a> {
    pub(crate) fn new(results: &'a Results, timings: Option<&'a Timings>, side_files: &'a SideFiles) -> Self {
        let chosen = at_most(&results.results, MOST_SECTIONS, |r| !r.as_expected);
        let mut slugs = Slugs::default();
        let mut cases = cases(results, &chosen, &mut slugs);
        let (seconds, logs) = (per_draw(timings), logs(timings));
        let mut subjects = vec![];
        for &i in &chosen {
            let result = &results.results[i];
            let home = home(&mut cases, result, results.media.len(), &mut slugs);
            cases[home].members.push(subjects.len());
            subjects.push(Subject {
                id: slugs.take("s-", &result.id),
                name: clean(&result.subject, 80),
                result,
                seconds: seconds.get(result.id.as_str()).copied(),
                log: logs.get(result.id.as_str()).copied().unwrap_or(""),
                case: home,
                on_ray: cases[home].medium.is_none_or(is_ray),
            });
        }
        Self { results, timings, side_files, subjects, beyond: beyond(results, &chosen), cases }
    }

    /// The subjects of a case.
    pub(crate) fn members(&self, case: &Case) -> Vec<&Subject<'a>> {
        case.members.iter().filter_map(|&i| self.subjects.get(i)).collect()
    }

    /// The subject of this id in the results.
    pub(crate) fn find(&self, id: &str) -> Option<&Subject<'a>> {
        self.subjects.iter().find(|subject| subject.result.id == id)
    }

    /// The rank of a kind among those that the results list: behind them all if it is not among them.
    pub(crate) fn rank_of_kind(&self, kind: &str) -> usize {
        let kinds = &self.results.kinds;
        kinds.iter().position(|listed| listed.name == kind).unwrap_or(kinds.len())
    }

    /// The heading of the subjects of a kind in the results, or else its name in words.
    pub(crate) fn heading_of_kind(&self, kind: &str) -> String {
        let listed = self.results.kinds.iter().find(|listed| listed.name == kind);
        listed.map_or_else(|| words(kind), |listed| listed.heading.clone())
    }

    /// The number of subjects that are as expected and not shown.
    pub(crate) fn left_out(&self) -> usize {
        self.results.results.len() - self.subjects.len() - self.beyond.len()
    }

    /// The number of media not shown, no shown subject having met them.
    pub(crate) fn media_left_out(&self) -> usize {
        self.results.media.len() - self.cases.iter().filter(|case| case.medium.is_some()).count()
    }
}

/// The media that the `chosen` subjects met, and as many others as have room.
fn cases<'a>(results: &'a Results, chosen: &[usize], slugs: &mut Slugs) -> Vec<Case<'a>> {
    let met: HashSet<usize> = chosen.iter().map(|&i| results.results[i].medium).collect();
    let numbered: Vec<(usize, &MediumResult)> = results.media.iter().enumerate().collect();
    let shown = at_most(&numbered, MOST_SECTIONS, |(i, _)| met.contains(i));
    shown.into_iter().map(|i| case(i, &results.media[i], slugs)).collect()
}

fn case<'a>(i: usize, medium: &'a MediumResult, slugs: &mut Slugs) -> Case<'a> {
    let title = title(medium);
    Case { id: slugs.take("c-", &title), number: i + 1, title, medium: Some(medium), members: vec![] }
}

/// The title of a case, with the ray if it has several.
pub(crate) fn title(medium: &MediumResult) -> String {
    let ray = medium.ray.map_or(String::new(), |ray| format!(", ray {ray}"));
    format!("{}{ray}", clean(&medium.case, 200))
}

/// The index of a subject's case; the first whose medium the results do not hold opens one more.
fn home(cases: &mut Vec<Case>, result: &SubjectResult, media: usize, slugs: &mut Slugs) -> usize {
    let number = if result.medium < media { result.medium + 1 } else { media + 1 };
    cases.binary_search_by_key(&number, |case| case.number).unwrap_or_else(|at| {
        let title = "Medium not in the results".to_string();
        cases.insert(at, Case { id: slugs.take("c-", &title), number, title, medium: None, members: vec![] });
        at
    })
}

/// The subjects that are not as expected and have no section.
fn beyond<'a>(results: &'a Results, chosen: &[usize]) -> Vec<&'a SubjectResult> {
    let chosen: HashSet<usize> = chosen.iter().copied().collect();
    let others = results.results.iter().enumerate().filter(|(i, _)| !chosen.contains(i));
    others.map(|(_, result)| result).filter(|result| !result.as_expected).collect()
}

fn logs(timings: Option<&Timings>) -> HashMap<&str, &str> {
    timings.iter().flat_map(|t| &t.subjects).map(|s| (s.id.as_str(), s.log.as_str())).collect()
}

fn per_draw(timings: Option<&Timings>) -> HashMap<&str, f64> {
    let all = timings.iter().flat_map(|t| &t.subjects).filter(|s| s.draws > 0);
    all.map(|s| (s.id.as_str(), s.seconds.0 / s.draws as f64)).collect()
}

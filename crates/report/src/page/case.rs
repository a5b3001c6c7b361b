//! One medium with its subjects.

use super::figure::{FigureView, Reading};
use super::ranking::{self, RankingView};
use super::subject::{SameClaims, SubjectView};
use crate::figures::Figures;
use crate::number::short;
use crate::site::{Site, is_ray};
use crate::text::{clean, words};
use freepath_results::MediumResult;

/// Subjects from which on a page names only tests that tell: thirty or more of each would be no reading.
const MANY: usize = 100;

/// The section of a case.
pub(crate) struct CaseView {
    pub(crate) id: String,
    pub(crate) number: usize,
    pub(crate) title: String,
    pub(crate) file: String,
    pub(crate) medium: String,
    pub(crate) parameters: String,
    pub(crate) figures: Vec<FigureView>,
    pub(crate) ranking: Option<RankingView>,
    pub(crate) subjects: Vec<SubjectView>,
}

impl CaseView {
    pub(crate) fn new(site: &Site, figures: &Figures, readings: &[Reading], i: usize) -> Self {
        let case = &site.cases[i];
        let none = vec![];
        let of = |member: usize| figures.subjects.get(member).unwrap_or(&none);
        let brief = site.subjects.len() > MANY;
        let view = |&m: &usize| Some(SubjectView::new(site.subjects.get(m)?, of(m), readings, brief));
        Self {
            id: case.id.clone(),
            number: case.number,
            title: case.title.clone(),
            file: case.medium.map_or_else(String::new, |m| clean(&m.file, 200)),
            medium: case.medium.map_or_else(String::new, sentence),
            parameters: case.medium.map_or_else(String::new, |m| clean(&m.parameters.to_string(), 600)),
            figures: FigureView::all(figures.cases.get(i).unwrap_or(&none)),
            ranking: ranking::of(site, case),
            subjects: once(case.members.iter().filter_map(view).collect(), brief),
        }
    }
}

/// What is claimed of several subjects of a case stands with the first of them, if `brief`.
fn once(mut subjects: Vec<SubjectView>, brief: bool) -> Vec<SubjectView> {
    for i in 1..if brief { subjects.len() } else { 0 } {
        let same = subjects[..i].iter().find(|of| of.claims_of.is_none() && of.claims == subjects[i].claims);
        let same = same.map(|of| SameClaims { id: of.letter.id.clone(), name: of.name.clone() });
        subjects[i].claims_of = same;
    }
    subjects
}

fn sentence(medium: &MediumResult) -> String {
    if !is_ray(medium) {
        return format!("Scene: {}.", clean(&words(&medium.medium), 60));
    }
    let tau: Vec<_> = medium.tau.iter().take(16).map(|tau| short(tau.0)).collect();
    let [least, greatest] = medium.extrema.map(|x| short(x.0));
    format!(
        "A {} medium, {} length units long; optical depth {}; extinction between {least} and {greatest} per length unit.",
        clean(&words(&medium.medium), 60),
        short(medium.length.0),
        tau.join(", ")
    )
}

//! Which plots a report has, and under which names.

use crate::plot::{Figure, cdf};
use crate::site::{Case, Site, Subject};

/// A plot with the name of its files.
pub(crate) struct Drawn {
    /// Without extension.
    pub(crate) file: String,
    pub(crate) figure: Figure,
}

/// The plots of each subject and of each case, in the order of the site.
pub(crate) struct Figures {
    pub(crate) subjects: Vec<Vec<Drawn>>,
    pub(crate) cases: Vec<Vec<Drawn>>,
}

impl Figures {
    pub(crate) fn all(&self) -> impl Iterator<Item = &Drawn> {
        self.cases.iter().chain(&self.subjects).flatten()
    }
}

/// All plots of `site`.
pub(crate) fn of(site: &Site) -> Figures {
    Figures {
        subjects: site
            .subjects
            .iter()
            .map(|subject| of_subject(site, subject))
            .collect(),
        cases: site.cases.iter().map(|case| of_case(site, case)).collect(),
    }
}

fn of_subject(site: &Site, subject: &Subject) -> Vec<Drawn> {
    let level = site.results.reporting_level.0;
    let series = &subject.result.series;
    let figures = [series.cdf.as_ref().map(|s| cdf::figure(s, &subject.name, level))];
    named(&subject.id, figures.into_iter().flatten())
}

fn of_case(_site: &Site, case: &Case) -> Vec<Drawn> {
    named(&case.id, [])
}

fn named(id: &str, figures: impl IntoIterator<Item = Figure>) -> Vec<Drawn> {
    let stem = id.split_once('-').map_or(id, |(_, rest)| rest);
    figures
        .into_iter()
        .map(|figure| Drawn {
            file: format!("{stem}-{}", figure.name),
            figure,
        })
        .collect()
}

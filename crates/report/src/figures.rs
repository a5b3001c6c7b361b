//! The plots of a report, and their names.

mod ladders;

use crate::plot::cost::Cost;
use crate::plot::forest::Entry;
use crate::plot::{
    DrawAxes, Figure, cdf, cost, efficiency, forest, histogram, life_table, medium, order, panel, power,
    quantiles, residuals, running,
};
use crate::site::{Case, Site, Subject, is_ray};
use crate::text::clean;
use freepath_results::{ChannelResult, Verdict};
use rayon::prelude::*;

/// A plot with the name of its files.
pub(crate) struct Drawn {
    /// Without extension.
    pub(crate) file: String,
    pub(crate) figure: Figure,
}

/// The plots of the run, of each subject and of each case, in the order of the site.
pub(crate) struct Figures {
    /// p-values of the run, then of the soak.
    pub(crate) level: Vec<Drawn>,
    pub(crate) power: Vec<Drawn>,
    pub(crate) subjects: Vec<Vec<Drawn>>,
    pub(crate) cases: Vec<Vec<Drawn>>,
}

impl Figures {
    pub(crate) fn all(&self) -> impl Iterator<Item = &Drawn> {
        let run = self.level.iter().chain(&self.power);
        run.chain(self.cases.iter().chain(&self.subjects).flatten())
    }
}

/// All plots of `site`.
pub(crate) fn of(site: &Site) -> Figures {
    Figures {
        level: named("r-run", level(site)),
        power: named("r-run", site.side_files.power.as_ref().and_then(power::figure)),
        subjects: site.subjects.par_iter().map(|subject| of_subject(site, subject)).collect(),
        cases: site.cases.par_iter().map(|case| of_case(site, case)).collect(),
    }
}

fn level(site: &Site) -> Vec<Figure> {
    let soak = site.side_files.soak.as_ref();
    let figures = [quantiles::of_run(site), soak.and_then(quantiles::of_soak), soak.and_then(quantiles::of_tests)];
    figures.into_iter().flatten().collect()
}

fn of_subject(site: &Site, subject: &Subject) -> Vec<Drawn> {
    let level = site.results.reporting_level.0;
    let (result, name) = (subject.result, &subject.name);
    let (series, axes) = (&result.series, DrawAxes::of(subject.on_ray));
    let figures = [
        broken(site, subject),
        series.cdf.as_ref().map(|s| cdf::figure(s, name, level, axes)),
        series.histogram.as_ref().map(|s| histogram::figure(s, name, axes)),
        series.residuals.as_ref().map(|s| residuals::figure(s, name, axes)),
        series.running.as_ref().zip(result.mean.as_ref()).map(|(s, mean)| running::figure(s, mean, name, level)),
        channels(subject),
    ];
    // a name for each file
    let panels = series.panels.iter().zip(["panel_0", "panel_1", "panel_2", "panel_3"]);
    let panels = panels.filter_map(|(series, file)| panel::figure(series, name, file));
    named(&subject.id, figures.into_iter().flatten().chain(panels))
}

/// The life table, where something was found: of a pass it is told in a sentence.
fn broken(site: &Site, subject: &Subject) -> Option<Figure> {
    let table = subject.result.series.life_table.as_ref().filter(|_| subject.result.verdict != Verdict::Pass)?;
    let medium = site.cases[subject.case].medium.and_then(|medium| medium.series.first());
    Some(life_table::figure(table, medium, &subject.name, site.results.reporting_level.0))
}

fn channels(subject: &Subject) -> Option<Figure> {
    let title = format!("{}: relative bias of each channel", subject.name);
    let entries = channel_entries(subject, "");
    (!entries.is_empty()).then(|| forest::figure(&entries, "channels", "Means of the channels", &title))
}

fn channel_entries<'a>(subject: &Subject<'a>, before: &str) -> Vec<Entry<'a>> {
    let verdict = subject.result.verdict;
    let label = |c: &ChannelResult| format!("{before}channel {}, {}", c.channel, clean(&c.event, 24));
    subject.result.channels.iter().map(|c| Entry { label: label(c), mean: &c.mean, verdict }).collect()
}

fn of_case(site: &Site, case: &Case) -> Vec<Drawn> {
    let members = site.members(case);
    let mut figures: Vec<Figure> =
        case.medium.filter(|m| is_ray(m)).map(|m| medium::figure(m, &case.title)).into_iter().collect();
    figures.extend(means(case, &members));
    let costs: Vec<Cost> = members.iter().filter_map(|s| paid(s)).collect();
    if !costs.is_empty() {
        figures.push(efficiency::figure(&costs, &case.title));
        figures.push(cost::figure(&costs, &case.title));
    }
    let ladders = ladders::of(&members);
    figures.extend(ladders.iter().map(|ladder| order::figure(ladder, "order", &case.title)));
    named(&case.id, figures)
}

fn means(case: &Case, members: &[&Subject]) -> Option<Figure> {
    let mut entries: Vec<Entry> = vec![];
    for subject in members.iter().filter(|s| !s.is_control()) {
        let verdict = subject.result.verdict;
        let mean = subject.result.mean.as_ref();
        entries.extend(mean.map(|mean| Entry { label: subject.name.clone(), mean, verdict }));
        entries.extend(channel_entries(subject, &format!("{}, ", clean(&subject.name, 18))));
    }
    let title = format!("{}: relative bias of each estimator", case.title);
    (!entries.is_empty()).then(|| forest::figure(&entries, "means", "Biases", &title))
}

fn paid<'a>(subject: &Subject<'a>) -> Option<Cost<'a>> {
    let efficiency = subject.result.efficiency.as_ref().filter(|_| !subject.is_control())?;
    let lookups = subject.lookups()?;
    Some(Cost { name: subject.name.clone(), efficiency, lookups, seconds: subject.seconds })
}

/// A second figure of the same name gets a number.
fn named(id: &str, figures: impl IntoIterator<Item = Figure>) -> Vec<Drawn> {
    let stem = id.split_once('-').map_or(id, |(_, rest)| rest);
    let mut drawn: Vec<Drawn> = vec![];
    for figure in figures {
        let before = drawn.iter().filter(|d| d.figure.name == figure.name).count();
        let number = if before > 0 { format!("-{}", before + 1) } else { String::new() };
        drawn.push(Drawn { file: format!("{stem}-{}{number}", figure.name), figure });
    }
    drawn
}

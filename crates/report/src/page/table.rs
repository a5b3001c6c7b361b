//! The table of all subjects.

use super::words::class;
use crate::number::{probability, short};
use crate::site::{Site, Subject};
use crate::text::{clean, words};
use freepath_results::{MeanResult, SubjectResult};

/// A number as shown and as sorted.
pub(crate) struct Cell {
    pub(crate) text: String,
    pub(crate) key: String,
}

impl Cell {
    fn new(value: Option<f64>, key: impl Fn(f64) -> f64) -> Self {
        let key = value.map(key).filter(|x| x.is_finite());
        Self {
            text: value.map_or_else(String::new, short),
            key: key.map_or_else(String::new, |x| format!("{x:e}")),
        }
    }
}

/// One subject in one line.
pub(crate) struct Row {
    pub(crate) id: String,
    pub(crate) verdict: String,
    pub(crate) class: &'static str,
    pub(crate) surprising: bool,
    pub(crate) subject: String,
    pub(crate) estimator: String,
    pub(crate) case: String,
    pub(crate) reasons: String,
    /// Smallest adjusted p, bias or distance, bound, detectable, look-ups.
    pub(crate) cells: Vec<Cell>,
}

impl Row {
    /// The rows, those that are not as expected above everything else.
    pub(crate) fn all(site: &Site) -> Vec<Self> {
        let mut rows: Vec<Row> = site.subjects.iter().map(|subject| Row::new(site, subject)).collect();
        rows.sort_by_key(|row| !row.surprising);
        rows
    }

    fn new(site: &Site, subject: &Subject) -> Self {
        let result = subject.result;
        let same = |x: f64| x;
        let [gap, bound, detectable] = measures(result);
        Self {
            id: subject.id.clone(),
            verdict: result.verdict.to_string(),
            class: class(result.verdict),
            surprising: !result.as_expected,
            subject: subject.name.clone(),
            estimator: estimator(subject),
            case: site.cases[subject.case].title.clone(),
            reasons: reasons(result),
            cells: vec![
                Cell {
                    text: smallest_p(result).map_or_else(String::new, probability),
                    ..Cell::new(smallest_p(result), same)
                },
                Cell::new(gap, f64::abs),
                Cell::new(bound, same),
                Cell::new(detectable, same),
                Cell::new(subject.lookups(), same),
            ],
        }
    }
}

/// The estimator's name, unless the subject's own begins with it.
fn estimator(subject: &Subject) -> String {
    let name = clean(&words(&subject.result.estimator), 60);
    if words(&subject.name).starts_with(&name) { String::new() } else { name }
}

/// The reasons as a short list.
pub(crate) fn reasons(result: &SubjectResult) -> String {
    let codes: Vec<_> = result.reasons.iter().take(20).map(|r| words(r.code())).collect();
    codes.join(", ")
}

/// The strongest evidence against a subject, in a few words.
pub(crate) fn evidence(result: &SubjectResult) -> String {
    if let Some(fact) = result.facts.first() {
        return format!("{}: {}", clean(&words(&fact.check), 60), clean(&fact.words, 120));
    }
    match result.tests.iter().filter(|t| t.rejects()).min_by(|a, b| key(a.p).total_cmp(&key(b.p))) {
        Some(test) => {
            format!(
                "{}: p {}",
                clean(&words(&test.name), 60),
                test.p.map_or("none".into(), |p| equal(probability(p.0)))
            )
        }
        None => result.notes.first().map_or_else(String::new, |note| clean(note, 120)),
    }
}

/// `= 0.1`, or `< 10⁻³⁰⁰` as it stands.
fn equal(p: String) -> String {
    if p.starts_with('<') { p } else { format!("= {p}") }
}

fn key(p: Option<freepath_results::Real>) -> f64 {
    p.map_or(2.0, |p| p.0)
}

/// The least adjusted p-value of stage 2, which decides, or else of stage 1.
fn smallest_p(result: &SubjectResult) -> Option<f64> {
    let of = |stage: u8| {
        let ps = result.tests.iter().filter(|t| t.stage == stage).filter_map(|t| t.p_adjusted);
        ps.map(|p| p.0).min_by(f64::total_cmp)
    };
    of(2).or_else(|| of(1))
}

/// Bias or distance, bound and detectable; of several channels, those of the worst.
fn measures(result: &SubjectResult) -> [Option<f64>; 3] {
    let of = |m: &MeanResult| [Some(m.bias.0), Some(m.bound.0), Some(m.detectable.0)];
    if let Some(mean) = &result.mean {
        return of(mean);
    }
    if let Some(law) = &result.law {
        return [Some(law.distance.0), Some(law.bound.0), Some(law.detectable.0)];
    }
    let worst = result.channels.iter().max_by(|a, b| a.mean.bias.0.abs().total_cmp(&b.mean.bias.0.abs()));
    worst.map_or([None; 3], |channel| of(&channel.mean))
}

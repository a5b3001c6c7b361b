//! One subject with everything that was found of it.

use super::figure::FigureView;
use super::matrix::Letter;
use super::words;
use crate::ReportError;
use crate::figures::Drawn;
use crate::number::{count, short};
use crate::site::Subject;
use crate::text::clean;
use freepath_harness::results::TestResult;

/// Most notes and tests that are shown of one subject.
const MOST: usize = 60;

/// Most lines of a program's standard error that are shown.
const MOST_LINES: usize = 1000;

/// The section of a subject.
pub(crate) struct SubjectView {
    pub(crate) letter: Letter,
    pub(crate) name: String,
    pub(crate) sentence: String,
    pub(crate) verdict: String,
    pub(crate) reasons: Vec<(&'static str, &'static str)>,
    pub(crate) notes: Vec<String>,
    pub(crate) measures: Vec<String>,
    pub(crate) expected: String,
    pub(crate) faults: String,
    pub(crate) draws: String,
    pub(crate) parameters: String,
    pub(crate) tests: Vec<TestRow>,
    pub(crate) repro: String,
    pub(crate) log: Vec<String>,
    pub(crate) figures: Vec<FigureView>,
}

/// One test in one stage.
pub(crate) struct TestRow {
    pub(crate) name: String,
    pub(crate) stage: u8,
    pub(crate) statistic: String,
    pub(crate) dof: String,
    pub(crate) p: String,
    pub(crate) adjusted: String,
    pub(crate) rejected: bool,
    pub(crate) note: String,
}

impl SubjectView {
    pub(crate) fn new(subject: &Subject, figures: &[Drawn]) -> Result<Self, ReportError> {
        let result = subject.result;
        let why = if result.expected_by_design { " (computed from its claims)" } else { "" };
        Ok(Self {
            letter: Letter::new(subject),
            name: subject.name.clone(),
            sentence: words::verdict(result),
            verdict: result.verdict.to_string(),
            reasons: result.reasons.iter().take(MOST).map(|r| (r.code(), r.words())).collect(),
            notes: result.notes.iter().take(MOST).map(|note| clean(note, 600)).collect(),
            measures: measures(subject),
            expected: format!("{}{why}", clean(&crate::text::words(&result.expected), 120)),
            faults: clean(&crate::text::words(&result.faults.join(", ")), 200),
            draws: draws(subject),
            parameters: clean(&result.parameters.to_string(), 600),
            tests: result.tests.iter().take(MOST).map(test).collect(),
            repro: clean(&result.repro, 1000),
            log: subject.log.lines().take(MOST_LINES).map(|line| clean(line, 1000)).collect(),
            figures: FigureView::all(figures)?,
        })
    }
}

fn measures(subject: &Subject) -> Vec<String> {
    let result = subject.result;
    let mut lines = result.mean.as_ref().map(words::mean).unwrap_or_default();
    lines.extend(result.law.as_ref().map(words::law).unwrap_or_default());
    for channel in result.channels.iter().take(MOST) {
        let name = format!("Channel {}, {}: ", channel.channel, clean(&channel.event, 40));
        let sentence = words::mean(&channel.mean).swap_remove(0);
        lines.push(name + &sentence.replacen("The mean", "the mean", 1));
    }
    let time = subject.seconds.map_or(String::new(), |s| format!(" {} ns per draw.", short(1e9 * s)));
    lines.push(words::audit(result) + &time);
    lines
}

fn draws(subject: &Subject) -> String {
    let result = subject.result;
    let second = if result.draws_stage2 > 0 {
        format!(" + {} in stage 2", count(result.draws_stage2))
    } else {
        String::new()
    };
    let left = match result.draws_left {
        0 => String::new(),
        left => format!("; {} more in the file, not judged", count(left)),
    };
    format!("{}{second} ({} asked for){left}", count(result.draws), count(result.draws_requested))
}

fn test(test: &TestResult) -> TestRow {
    let optional = |x: Option<freepath_harness::real::Real>| x.map_or_else(|| "–".into(), |x| short(x.0));
    TestRow {
        name: clean(&crate::text::words(&test.name), 60),
        stage: test.stage,
        statistic: short(test.statistic.0),
        dof: optional(test.dof),
        p: optional(test.p),
        adjusted: optional(test.p_adjusted),
        rejected: test.rejected,
        note: clean(&test.note, 300),
    }
}

//! One subject with everything that was found of it.

use super::figure::{FigureView, Reading, is_quiet};
use super::matrix::Letter;
use super::words;
use crate::figures::Drawn;
use crate::number::{count, probability, short};
use crate::shown::at_most;
use crate::site::Subject;
use crate::text::clean;
use freepath_results::{FactResult, Real, Reason, SubjectResult, TestResult};
use freepath_statistics::decide::SUSPECT;

/// Most claims, notes and tests that are shown of one subject.
const MOST: usize = 60;

/// Most lines of a program's standard error that are shown.
const MOST_LINES: usize = 1000;

/// The section of a subject.
pub(crate) struct SubjectView {
    /// Its plots stand side by side, and what they show is told once for all.
    pub(crate) quiet: bool,
    pub(crate) letter: Letter,
    pub(crate) name: String,
    pub(crate) sentence: String,
    pub(crate) verdict: String,
    pub(crate) reasons: Vec<ReasonView>,
    pub(crate) notes: Vec<String>,
    pub(crate) measures: Vec<String>,
    pub(crate) expected: String,
    pub(crate) faults: String,
    pub(crate) draws: String,
    pub(crate) parameters: String,
    pub(crate) claims: Vec<String>,
    /// The subject before it of which just the same is claimed.
    pub(crate) claims_of: Option<SameClaims>,
    pub(crate) facts: Vec<FactRow>,
    pub(crate) tests: Vec<TestRow>,
    /// A note on what is shown only in part.
    pub(crate) left_out: String,
    pub(crate) repro: String,
    pub(crate) log: Vec<String>,
    pub(crate) figures: Vec<FigureView>,
}

/// A subject of the same case of which the same is claimed.
pub(crate) struct SameClaims {
    pub(crate) id: String,
    pub(crate) name: String,
}

/// A reason with what usually causes it.
pub(crate) struct ReasonView {
    pub(crate) code: &'static str,
    pub(crate) words: &'static str,
    pub(crate) causes: String,
    pub(crate) advice: String,
}

/// One fact.
pub(crate) struct FactRow {
    pub(crate) check: String,
    pub(crate) stage: u8,
    pub(crate) code: &'static str,
    pub(crate) words: String,
}

/// One test in one stage, or several of no interest.
#[derive(Default)]
pub(crate) struct TestRow {
    pub(crate) name: String,
    pub(crate) stage: String,
    pub(crate) statistic: String,
    pub(crate) dof: String,
    pub(crate) p: String,
    pub(crate) adjusted: String,
    pub(crate) class: &'static str,
    pub(crate) decision: &'static str,
    pub(crate) note: String,
}

impl SubjectView {
    /// With the tests that tell, if `brief`; the others are counted.
    pub(crate) fn new(subject: &Subject, figures: &[Drawn], readings: &[Reading], brief: bool) -> Self {
        let result = subject.result;
        let why = if result.expected_by_design { " (computed from its claims)" } else { "" };
        let (quiet, advised) = (is_quiet(subject), !(brief && result.as_expected));
        Self {
            quiet,
            letter: Letter::new(subject),
            name: subject.name.clone(),
            sentence: words::verdict(result),
            verdict: result.verdict.to_string(),
            reasons: result.reasons.iter().take(MOST).map(|of| reason(of, advised)).collect(),
            notes: notes(result),
            measures: measures(subject),
            expected: format!("{}{why}", clean(&crate::text::words(&result.expected), 120)),
            faults: clean(&crate::text::words(&result.faults.join(", ")), 200),
            draws: draws(subject),
            parameters: clean(&result.parameters.to_string(), 600),
            claims: result.claims.iter().take(MOST).map(|claim| clean(&claim.statement, 200)).collect(),
            claims_of: None,
            facts: result.facts.iter().take(MOST).map(fact).collect(),
            tests: rows(result, brief && result.as_expected),
            left_out: left_out(result),
            repro: clean(&result.repro, 1000),
            log: subject.log.lines().take(MOST_LINES).map(|line| clean(line, 1000)).collect(),
            figures: FigureView::with_readings(figures, if quiet { readings } else { &[] }),
        }
    }
}

/// With its usual causes, unless it was expected and one of many.
fn reason(reason: &Reason, advised: bool) -> ReasonView {
    let part = |name| if advised { paragraph(reason.advice(), name) } else { String::new() };
    ReasonView { code: reason.code(), words: reason.words(), causes: part("Causes:"), advice: part("Do:") }
}

/// Notes that the tables of tests and facts do not hold.
fn notes(result: &SubjectResult) -> Vec<String> {
    let facts = || result.facts.iter().take(MOST);
    let rejected: Vec<_> = tests(result).into_iter().filter(|test| test.rejects()).collect();
    let of_test = |note: &str| {
        rejected.iter().any(|t| note.strip_prefix(&t.name).is_some_and(|of| of.starts_with(" rejects ")))
    };
    let told = |note: &&String| facts().any(|fact| fact.words == **note) || of_test(note);
    result.notes.iter().take(MOST).filter(|note| !told(note)).map(|note| clean(note, 600)).collect()
}

/// The tests that are shown: those that reject before all others.
fn tests(result: &SubjectResult) -> Vec<&TestResult> {
    at_most(&result.tests, MOST, TestResult::rejects).into_iter().map(|i| &result.tests[i]).collect()
}

/// The rows of the tests; if `brief`, of those that tell, and one for all others.
fn rows(result: &SubjectResult, brief: bool) -> Vec<TestRow> {
    let telling = |of: &&TestResult| !brief || (tells(of) && !of.reported);
    let (telling, silent): (Vec<_>, Vec<_>) = tests(result).into_iter().partition(telling);
    let mut rows = Vec::new();
    telling.into_iter().for_each(|of| add(test(of), brief, &mut rows));
    rows.into_iter().chain(others(&silent)).collect()
}

/// One more row; if `brief`, what was withheld in both stages for one reason is one row of both.
fn add(row: TestRow, brief: bool, rows: &mut Vec<TestRow>) {
    let same = |of: &&mut TestRow| (&of.name, of.decision, &of.note) == (&row.name, WITHHELD, &row.note);
    match rows.iter_mut().find(same).filter(|_| brief && row.decision == WITHHELD) {
        Some(first) => first.stage = format!("{}, {}", first.stage, row.stage),
        None => rows.push(row),
    }
}

/// The decision on a test without a p-value.
const WITHHELD: &str = "withheld";

/// True of a test that rejects, that has no p-value, or one that gives cause for stage 2.
fn tells(test: &TestResult) -> bool {
    test.p.is_none_or(|p| !(p.0 > SUSPECT)) || test.rejects() || test.reported
}

/// One row for all tests of no interest.
fn others(silent: &[&TestResult]) -> Option<TestRow> {
    let least = silent
        .iter()
        .filter(|test| !test.reported)
        .filter_map(|test| test.p)
        .map(|p| p.0)
        .min_by(f64::total_cmp)?;
    let name = if silent.len() == 1 { "1 other".into() } else { format!("{} others", silent.len()) };
    let p = format!("{} or more", probability(least));
    Some(TestRow { name, p, ..TestRow::default() })
}

fn left_out(result: &SubjectResult) -> String {
    let rejected = |tests: &mut dyn Iterator<Item = &TestResult>| tests.filter(|test| test.rejects()).count();
    let unseen = rejected(&mut result.tests.iter()) - rejected(&mut tests(result).into_iter());
    let lengths = [
        ("claims", result.claims.len()),
        ("notes", result.notes.len()),
        ("facts", result.facts.len()),
        ("tests", result.tests.len()),
        ("channels", result.channels.len()),
    ];
    let cut = lengths.iter().filter(|(_, length)| *length > MOST);
    let cut: Vec<_> = cut.map(|(what, length)| format!("{} {what}", length - MOST)).collect();
    match (cut.is_empty(), unseen) {
        (true, _) => String::new(),
        (false, 0) => {
            format!("Left out here and told of in results.json: {}; no test among them rejects.", cut.join(", "))
        }
        (false, n) => {
            format!("Left out here and told of in results.json: {}; {n} of the tests reject.", cut.join(", "))
        }
    }
}

/// The paragraph of `text` that begins with `name`, in one line and with the full stop that ends it.
fn paragraph(text: &str, name: &str) -> String {
    let mut lines = text.lines().skip_while(|line| !line.starts_with(name));
    let first = lines.next().and_then(|line| line.strip_prefix(name)).unwrap_or_default().trim();
    let rest = lines.take_while(|line| line.starts_with(' '));
    rest.fold(first.to_string(), |all, line| all + " " + line.trim()).replace('`', "")
}

fn fact(fact: &FactResult) -> FactRow {
    FactRow {
        check: clean(&crate::text::words(&fact.check), 60),
        stage: fact.stage,
        code: fact.reason.code(),
        words: clean(&fact.words, 600),
    }
}

fn measures(subject: &Subject) -> Vec<String> {
    let result = subject.result;
    let mut lines = result.mean.as_ref().map(words::mean).unwrap_or_default();
    lines.extend(result.law.as_ref().map(|law| words::law(law, subject.on_ray)).unwrap_or_default());
    lines.extend(result.series.life_table.as_ref().and_then(words::life_table));
    for channel in result.channels.iter().take(MOST) {
        let name = format!("Channel {}, {}: ", channel.channel, clean(&channel.event, 40));
        let mut sentences = words::mean(&channel.mean);
        lines.push(name + &sentences.remove(0).replacen("The mean", "the mean", 1));
        lines.extend(channel.mean.grown.as_ref().and(sentences.pop()));
    }
    lines.extend(result.weighted_laws.iter().take(MOST).map(words::weighted_law));
    let time = subject.seconds.map_or(String::new(), |s| format!(" {} ns per draw.", short(1e9 * s)));
    lines.push(if subject.on_ray { words::audit(subject) + &time } else { time.trim_start().into() });
    lines.retain(|line| !line.is_empty());
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

/// A test that was withheld has none.
fn statistic(test: &TestResult) -> String {
    if test.p.is_none() && test.statistic.0.is_nan() { String::new() } else { short(test.statistic.0) }
}

fn test(test: &TestResult) -> TestRow {
    let shown = |x: Option<Real>, as_text: fn(f64) -> String| x.map_or_else(String::new, |x| as_text(x.0));
    let chance = |p| shown(p, probability);
    let (class, decision) = match test {
        TestResult { rejected_alone: true, .. } => ("rejected", "rejected alone"),
        TestResult { rejected: true, .. } => ("rejected", "rejected"),
        TestResult { reported: true, .. } => ("reported", "shown"),
        TestResult { p: None, .. } => ("reported", WITHHELD),
        _ => ("", ""), // the glossary says that it is not rejected
    };
    TestRow {
        name: clean(&crate::text::words(&test.name), 60),
        stage: test.stage.to_string(),
        statistic: statistic(test),
        dof: shown(test.dof, short),
        p: chance(test.p),
        adjusted: chance(test.p_adjusted),
        class,
        decision,
        // that of a p-value which gives no cause for stage 2 tells of chance alone, and is left to results.json
        note: if tells(test) { clean(&test.note, 300) } else { String::new() },
    }
}

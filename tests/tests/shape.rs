//! Names, keys and their order in results.json stay what they are: other programs read them, and the order of tests, facts and
//! reasons, and the key of a subject's stream, decide what a run writes to the last byte.
//!
//! The chosen cases hold every kind, test, fact and reason that a shipped case brings out. `shape.txt` is rewritten by
//! `FREEPATH_REWRITE=1 cargo test -p freepath-tests --test shape`, to be read as a diff: a name that changes there breaks others.

use freepath_harness::case::{Limits, Prepared};
use freepath_results::{Results, SubjectResult};
use freepath_tests::{load, results, root};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

/// Case files with the draws of stage 1: where a block is too little, something is only seen with more.
const CASES: &[(&str, u64)] = &[
    ("agreement", 131_072),
    ("agreement_grid", 16_384),
    ("bias_bound", 16_384),
    ("chromatic", 16_384),
    ("chromatic_five", 16_384),
    ("density", 16_384),
    ("discrete", 16_384),
    ("number", 16_384),
    ("samples", 16_384),
    ("thin", 16_384),
    ("controls/density_cutoff", 16_384),
    ("controls/dropped_channel", 16_384),
    ("controls/dropped_channel_dense", 16_384),
    ("controls/half_step", 16_384),
    ("controls/masked_majorant", 16_384),
    ("controls/leaked_record", 16_384),
    ("controls/rounded_null", 131_072),
    ("controls/same_seed", 16_384),
    ("controls/shortened_segment", 16_384),
    ("controls/split_products", 16_384),
    ("controls/uncut_segment", 16_384),
    ("controls/zero_step", 16_384),
    ("controls/zero_weight_drawn", 16_384),
];

/// The names of a run, as text: subjects first, then the keys of everything.
#[derive(Default)]
struct Shape {
    subjects: String,
    /// Keys of subjects, with the subjects that have just these.
    keys: BTreeMap<String, Vec<String>>,
    /// Keys of the rest.
    others: BTreeMap<String, usize>,
}

impl Shape {
    fn add(&mut self, name: &str, cases: &[Prepared], results: &Results) {
        let streams = cases.iter().flat_map(|case| &case.subjects);
        assert_eq!(streams.clone().count(), results.results.len());
        let _ = writeln!(self.subjects, "\n== cases/{name}.json");
        for (prepared, result) in streams.zip(&results.results) {
            assert_eq!(prepared.name, result.subject);
            let _ = writeln!(self.subjects, "{}\n  stream {:016x}\n{}", result.id, prepared.key, found(result));
        }
        let mut json = serde_json::to_value(results).expect("results are JSON");
        for (subject, result) in json["results"].as_array_mut().into_iter().flatten().zip(&results.results) {
            subject["parameters"] = Value::Null; // as the case has them
            self.keys.entry(lines(subject)).or_default().push(result.id.clone());
        }
        json["results"] = Value::Null;
        json["media"].as_array_mut().into_iter().flatten().for_each(|medium| medium["parameters"] = Value::Null);
        *self.others.entry(lines(&json)).or_default() += 1;
    }

    fn text(&self) -> String {
        let mut text = "Names, keys and their order in results.json: see tests/tests/shape.rs.\n".to_string();
        text += &self.subjects;
        for (keys, count) in &self.others {
            let _ = writeln!(text, "\n== keys of results.json, of {count} runs\n{keys}");
        }
        for (keys, subjects) in &self.keys {
            let _ = writeln!(text, "\n== keys of a subject, of {}\n{keys}", subjects.join("\n   and "));
        }
        text
    }
}

/// Tests by stage, facts and reasons, each in its order.
fn found(result: &SubjectResult) -> String {
    let names = |stage| result.tests.iter().filter(move |test| test.stage == stage).map(|test| test.name.as_str());
    let stage = |stage| names(stage).collect::<Vec<_>>().join(", ");
    let facts = result.facts.iter().map(|fact| format!("{} {} {}", fact.stage, fact.check, fact.reason));
    let reasons = result.reasons.iter().map(ToString::to_string);
    let rows = [
        ("stage 1", stage(1)),
        ("stage 2", stage(2)),
        ("facts", facts.collect::<Vec<_>>().join(", ")),
        ("reasons", reasons.collect::<Vec<_>>().join(", ")),
    ];
    let told = rows.iter().filter(|(_, names)| !names.is_empty());
    told.map(|(what, names)| format!("  {what}: {names}")).collect::<Vec<_>>().join("\n")
}

/// The keys of an object in their order: a line for each that holds others, and for those between.
fn lines(value: &Value) -> String {
    let members: Vec<_> = value.as_object().into_iter().flatten().map(|(key, value)| (key, keys(value))).collect();
    let lines = members.chunk_by(|(_, before), (_, after)| before.is_empty() && after.is_empty());
    let line = |members: &[(&String, String)]| {
        let words: Vec<_> = members.iter().map(|(key, inside)| format!("{key}{inside}")).collect();
        format!("  {}", words.join(", "))
    };
    lines.map(line).collect::<Vec<_>>().join("\n")
}

/// The keys inside a value, in their order; of a list, those of its different items.
fn keys(value: &Value) -> String {
    match value {
        Value::Object(members) => {
            let inside: Vec<_> = members.iter().map(|(key, value)| format!("{key}{}", keys(value))).collect();
            format!(" {{ {} }}", inside.join(", "))
        }
        Value::Array(items) => {
            let mut kinds: Vec<_> = items.iter().map(keys).filter(|keys| !keys.is_empty()).collect();
            kinds.sort();
            kinds.dedup();
            if kinds.is_empty() { " []".into() } else { format!(" [{} ]", kinds.join(" |")) }
        }
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => String::new(),
    }
}

fn one(name: &str, draws: u64) -> (Vec<Prepared>, Results) {
    // Ids begin with the path of the case, which must not be that of this machine.
    std::env::set_current_dir(root()).expect("the repository is there");
    let limits = Limits { draws: Some(draws), ..Limits::default() };
    let cases = load(Path::new(&format!("cases/{name}.json")), &limits);
    let found = results(&cases, 1);
    (cases, found)
}

#[test]
fn names_keys_and_order_are_as_they_were() {
    let mut shape = Shape::default();
    for (name, draws) in CASES {
        let (cases, results) = one(name, *draws);
        shape.add(name, &cases, &results);
    }
    let (path, text) = (root().join("tests/shape.txt"), shape.text());
    if std::env::var_os("FREEPATH_REWRITE").is_some() {
        std::fs::write(&path, &text).expect("shape.txt can be written");
    }
    let known = std::fs::read_to_string(&path).unwrap_or_default();
    let differs = text.lines().zip(known.lines().chain([""])).position(|(now, then)| now != then);
    if let Some(at) = differs.or((text != known).then_some(text.lines().count())) {
        let line = |text: &str| text.lines().nth(at).unwrap_or("nothing").to_string();
        panic!(
            "tests/shape.txt line {}:\n  was {}\n  is  {}\n(if on purpose, FREEPATH_REWRITE=1)",
            at + 1,
            line(&known),
            line(&text)
        );
    }
}

#[test]
fn another_order_is_another_shape() {
    let (cases, results) = one("controls/uncut_segment", 16_384);
    let of = |cases: &[Prepared], results: &Results| {
        let mut shape = Shape::default();
        shape.add("case", cases, results);
        shape.text()
    };
    let before = of(&cases, &results);
    let subject = |change: fn(&mut SubjectResult)| {
        let mut other = results.clone();
        other.results.iter_mut().for_each(change);
        of(&cases, &other)
    };
    assert_eq!(before, of(&cases, &results));
    assert_ne!(before, subject(|r| r.tests.swap(0, 1)), "tests");
    assert_ne!(before, subject(|r| r.facts.reverse()), "facts");
    assert_ne!(before, subject(|r| r.reasons.reverse()), "reasons");
    assert_ne!(before, subject(|r| r.id.push('x')), "ids");
    assert_ne!(before, subject(|r| r.law = None), "keys");
    let mut cases = cases;
    cases[0].subjects[0].key += 1;
    assert_ne!(before, of(&cases, &results), "streams");
}

#[test]
fn another_order_of_keys_is_another_shape() {
    let of = |text: &str| lines(&serde_json::from_str(text).expect("it is JSON"));
    assert_eq!(of(r#"{"a": 1, "b": [{"c": 2}]}"#), of(r#"{"a": null, "b": [{"c": 0}, {"c": 1}]}"#));
    assert_ne!(of(r#"{"a": 1, "b": 2}"#), of(r#"{"b": 2, "a": 1}"#));
    assert_ne!(of(r#"{"b": [{"c": 2, "d": 3}]}"#), of(r#"{"b": [{"d": 3, "c": 2}]}"#));
}

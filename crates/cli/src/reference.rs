//! Every name that a case can use, and every test and reason, as the schema of a case and the lists of the harness tell.

mod doc;
mod example;
mod fields;
mod markdown;

use doc::plain;
pub(crate) use fields::Field;
use fields::fields;
use freepath_harness::case::{self, KINDS, variants};
use freepath_harness::describe::CHECKS;
use freepath_results::Reason;
use freepath_statistics::check::Check;
use freepath_statistics::hypothesis::TESTS;
pub(crate) use markdown::page;

/// One name.
#[derive(Debug)]
pub(crate) struct Entry {
    /// The kind of its name, such as `medium`.
    pub(crate) kind: &'static str,
    /// As a case has it.
    pub(crate) name: String,
    /// All that is said of it.
    pub(crate) words: String,
    /// Its parameters.
    pub(crate) fields: Vec<Field>,
    /// An example of it in a case; empty if it does not stand in one.
    pub(crate) example: String,
    /// The other fields in the record of a test or of a check.
    pub(crate) told: Option<Told>,
}

/// The fields that only a test or a check has.
#[derive(Debug)]
pub(crate) struct Told {
    /// All but the first words, as plain text.
    pub(crate) details: String,
    /// Its section of `docs/statistics.md`, as a link has it.
    pub(crate) section: &'static str,
}

impl Entry {
    /// The first sentence.
    pub(crate) fn summary(&self) -> String {
        doc::summary(&self.words)
    }
}

/// A part of a case whose names are in its schema.
struct InSchema {
    /// The kind of the names, such as `medium`.
    kind: &'static str,
    /// Its definition.
    definition: String,
}

/// The kinds of subjects, and what else a case names.
fn in_schema() -> impl Iterator<Item = InSchema> {
    let subjects = KINDS.iter().map(|kind| InSchema { kind: kind.name, definition: kind.definition() });
    let others = [
        ("scene", "AnyScene"),
        ("medium", "AnyMedium"),
        ("majorant", "MajorantChoice"),
        ("fault", "Fault"),
        ("claim", "Claim"),
        ("agreement", "Agreement"),
    ];
    subjects.chain(others.map(|(kind, definition)| InSchema { kind, definition: definition.into() }))
}

/// Every name, by kind.
pub(crate) fn entries() -> Vec<Entry> {
    let schema = case::schema();
    let of_kind = |part: InSchema| {
        let variants = variants(&schema, &schema["$defs"][&part.definition]);
        variants.into_iter().map(move |(name, body, words)| (part.kind, name, body, words))
    };
    let known = in_schema().flat_map(of_kind);
    let mut entries: Vec<Entry> = known
        .map(|(kind, name, body, words)| {
            let fields = fields(&schema, body);
            Entry {
                example: example::of(&schema, kind, name, body),
                kind,
                name: name.to_string(),
                words: plain(words),
                fields,
                told: None,
            }
        })
        .collect();
    entries.extend(tests());
    entries.extend(reasons());
    entries
}

fn tests() -> impl Iterator<Item = Entry> {
    let tests = TESTS.iter().map(|test| told("test", test.name, test.words, test.details, test.section));
    let check = |check: &Check| told("check", check.name, check.words, check.details, check.section);
    tests.chain(CHECKS.iter().map(check))
}

/// The entry of a record.
fn told(kind: &'static str, name: &str, words: &str, details: &str, section: &'static str) -> Entry {
    Entry {
        kind,
        name: name.to_string(),
        words: plain(&format!("{words}\n\n{details}")),
        fields: Vec::new(),
        example: String::new(),
        told: Some(Told { details: details.replace("```text\n", "").replace("```\n", ""), section }),
    }
}

fn reasons() -> impl Iterator<Item = Entry> {
    Reason::ALL.iter().map(|reason| Entry {
        kind: "reason",
        name: reason.code().to_string(),
        words: format!("{}\n\n{}", sentence(reason.words()), reason.advice()),
        fields: Vec::new(),
        example: format!("\"expect\": {{ \"fail\": \"{reason}\" }}"),
        told: None,
    })
}

/// `words` with a capital and a full stop.
fn sentence(words: &str) -> String {
    let mut letters = words.chars();
    let first = letters.next().map(|c| c.to_ascii_uppercase());
    first.into_iter().chain(letters).chain(['.']).collect()
}

//! Every name that a case can use, and every test and reason, as the schema of a case and the lists of the harness tell.

mod doc;
mod example;
mod fields;

use doc::plain;
pub(crate) use fields::Field;
use fields::fields;
use freepath_harness::case::{self, variants};
use freepath_harness::describe;
use freepath_results::Reason;
use freepath_statistics::hypothesis;

/// One name.
#[derive(Debug)]
pub(crate) struct Entry {
    /// What it is a name of.
    pub(crate) kind: &'static str,
    /// As a case has it.
    pub(crate) name: String,
    /// All that is said of it.
    pub(crate) words: String,
    /// Its parameters.
    pub(crate) fields: Vec<Field>,
    /// How it stands in a case; empty if it does not.
    pub(crate) example: String,
}

impl Entry {
    /// The first sentence.
    pub(crate) fn summary(&self) -> String {
        doc::summary(&self.words)
    }
}

/// The parts of a case whose names are in its schema: what they are called, and the definition.
const IN_SCHEMA: &[(&str, &str)] = &[
    ("free_path", "FreePathSubject"),
    ("transmittance", "TransmittanceSubject"),
    ("chromatic", "ChromaticSubject"),
    ("medium", "AnyMedium"),
    ("majorant", "MajorantChoice"),
    ("fault", "Fault"),
    ("claim", "Claim"),
    ("agreement", "Agreement"),
];

/// Every name, by kind.
pub(crate) fn entries() -> Vec<Entry> {
    let schema = case::schema();
    let of_kind = |&(kind, definition): &(&'static str, &str)| {
        let variants = variants(&schema, &schema["$defs"][definition]);
        variants.into_iter().map(move |(name, body, words)| (kind, name, body, words))
    };
    let known = IN_SCHEMA.iter().flat_map(of_kind);
    let mut entries: Vec<Entry> = known
        .map(|(kind, name, body, words)| {
            let fields = fields(&schema, body);
            Entry {
                example: example::of(&schema, kind, name, body),
                kind,
                name: name.to_string(),
                words: plain(words),
                fields,
            }
        })
        .collect();
    entries.extend(tests());
    entries.extend(reasons());
    entries
}

fn tests() -> impl Iterator<Item = Entry> {
    let named = |kind| move |entry: &(&'static str, &'static str)| (kind, entry.0, entry.1);
    let all = hypothesis::NAMES.iter().map(named("test")).chain(describe::CHECKS.iter().map(named("check")));
    all.map(|(kind, name, words)| Entry {
        kind,
        name: name.to_string(),
        words: plain(&format!("{words}\n\n{}", describe::details(name).unwrap_or_default())),
        fields: Vec::new(),
        example: String::new(),
    })
}

fn reasons() -> impl Iterator<Item = Entry> {
    Reason::ALL.iter().map(|reason| Entry {
        kind: "reason",
        name: reason.code().to_string(),
        words: format!("{}\n\n{}", sentence(reason.words()), reason.advice()),
        fields: Vec::new(),
        example: format!("\"expect\": {{ \"fail\": \"{reason}\" }}"),
    })
}

/// `words` with a capital and a full stop.
fn sentence(words: &str) -> String {
    let mut letters = words.chars();
    let first = letters.next().map(|c| c.to_ascii_uppercase());
    first.into_iter().chain(letters).chain(['.']).collect()
}

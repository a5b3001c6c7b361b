//! `case.schema.json` is the schema of a case, and knows every name and every field.

use freepath_estimators::medium::AnyMedium;
use freepath_harness::case::{self, CaseFile, KINDS};
use freepath_harness::fault::Fault;
use freepath_results::Reason;
use serde_json::Value;
use std::fs;
use std::path::Path;

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

#[test]
fn the_committed_schema_is_current() {
    let committed = fs::read_to_string(root().join("case.schema.json")).unwrap_or_default();
    let current = format!("{:#}\n", case::schema());
    assert!(committed == current, "run `cargo run -- schema > case.schema.json`");
}

/// Every key and every constant below `node`.
fn words(node: &Value, found: &mut Vec<String>) {
    match node {
        Value::Object(fields) => {
            for (key, value) in fields {
                found.push(key.clone());
                words(value, found);
            }
        }
        Value::Array(items) => items.iter().for_each(|item| words(item, found)),
        Value::String(text) => found.push(text.clone()),
        Value::Null | Value::Bool(_) | Value::Number(_) => {}
    }
}

#[test]
fn every_name_is_in_the_schema() {
    let mut found = Vec::new();
    words(&case::schema(), &mut found);
    let faults = Fault::NAMES.iter().map(|(name, _)| *name);
    let reasons = Reason::ALL.iter().map(|reason| reason.code());
    let subjects = KINDS.iter().flat_map(|kind| (kind.names)()).copied();
    let media = AnyMedium::NAMES.iter().copied();
    for name in faults.chain(reasons).chain(subjects).chain(media) {
        assert!(found.iter().any(|word| word == name), "{name} is not in the schema");
    }
}

#[test]
fn every_definition_has_words_and_refuses_unknown_fields() {
    let schema = case::schema();
    for (name, definition) in schema["$defs"].as_object().into_iter().flatten() {
        let Some(fields) = definition["properties"].as_object() else {
            continue;
        };
        assert_eq!(definition["additionalProperties"], false, "{name}");
        assert!(definition["description"].is_string(), "{name} has no words");
        for (field, node) in fields {
            assert!(node["description"].is_string(), "{name}.{field} has no words");
        }
    }
}

/// The keys of `value` that the schema does not know: those that no definition on the way has.
fn unknown(schema: &Value, node: &Value, value: &Value) -> Vec<String> {
    let node = match node["$ref"].as_str().and_then(|to| to.strip_prefix('#')) {
        Some(to) => schema.pointer(to).unwrap_or(&Value::Null),
        None => node,
    };
    let choices = ["oneOf", "anyOf"].iter().find_map(|key| node[*key].as_array());
    if let (Some(choices), false) = (choices, node["properties"].is_object()) {
        let all = choices.iter().map(|choice| unknown(schema, choice, value));
        return all.min_by_key(Vec::len).unwrap_or_default();
    }
    match value {
        Value::Object(fields) => fields
            .iter()
            .flat_map(|(key, value)| match node["properties"].get(key) {
                Some(node) => unknown(schema, node, value),
                None => vec![key.clone()],
            })
            .collect(),
        Value::Array(items) => items.iter().flat_map(|item| unknown(schema, &node["items"], item)).collect(),
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => Vec::new(),
    }
}

#[test]
fn the_schema_knows_every_key_of_the_shipped_cases() {
    let schema = case::schema();
    for folder in ["cases", "cases/controls"] {
        let files = fs::read_dir(root().join(folder)).map(|files| files.flatten().map(|file| file.path()));
        for path in files.into_iter().flatten().filter(|path| path.extension().is_some_and(|end| end == "json")) {
            let case = CaseFile::load(&path).map(|file| file.case);
            let case = serde_json::to_value(case.unwrap_or_else(|why| panic!("{why}"))).unwrap_or_default();
            assert_eq!(unknown(&schema, &schema, &case), Vec::<String>::new(), "{}", path.display());
        }
    }
}

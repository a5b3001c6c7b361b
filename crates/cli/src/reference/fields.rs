//! The parameters of a name, as its schema tells.

use super::doc::plain;
use freepath_harness::case::{resolve, variants};
use serde_json::Value;

/// One parameter.
#[derive(Debug)]
pub(crate) struct Field {
    /// Its key; empty if the name takes a value instead of an object.
    pub(crate) name: String,
    /// The values allowed there.
    pub(crate) takes: String,
    /// The value if it is left out; none if it is required.
    pub(crate) default: Option<String>,
    /// Its meaning.
    pub(crate) words: String,
}

/// The parameters that `body` takes.
pub(super) fn fields(schema: &Value, body: &Value) -> Vec<Field> {
    if body.is_null() {
        return Vec::new();
    }
    let Some(properties) = body["properties"].as_object() else {
        return value(schema, body).into_iter().collect();
    };
    let field = |(name, node): (&String, &Value)| {
        let own = node["description"].as_str();
        let words = own.or_else(|| resolve(schema, node)["description"].as_str()).unwrap_or("");
        Field {
            name: name.clone(),
            takes: takes(schema, node),
            default: default(body, name, node),
            words: plain(words).replace('\n', " "),
        }
    };
    properties.iter().map(field).collect()
}

/// A name may be followed by a number or a list instead of an object.
fn value(schema: &Value, body: &Value) -> Option<Field> {
    let takes = takes(schema, body);
    (takes != "object").then(|| Field { name: String::new(), takes, default: None, words: String::new() })
}

fn default(body: &Value, name: &str, node: &Value) -> Option<String> {
    let required = body["required"].as_array().is_some_and(|names| names.iter().any(|other| other == name));
    match (&node["default"], required) {
        (_, true) => None,
        (Value::Null, false) => Some("none".into()),
        (value, false) => Some(value.to_string()),
    }
}

/// The values allowed at `node`, in a few words.
fn takes(schema: &Value, node: &Value) -> String {
    if node["$ref"] == "#/$defs/AnyMedium" {
        return "medium".into();
    }
    let node = resolve(schema, node);
    let names = variants(schema, node);
    let kind = match &node["type"] {
        Value::Array(kinds) => kinds.iter().find_map(|kind| kind.as_str().filter(|kind| *kind != "null")),
        Value::String(kind) => Some(kind.as_str()),
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::Object(_) => None,
    };
    match kind {
        _ if node["oneOf"].is_array() || node["anyOf"].is_array() || node["enum"].is_array() => {
            let quoted: Vec<_> = names.iter().map(|(name, ..)| format!("\"{name}\"")).collect();
            quoted.join(" | ")
        }
        Some("integer") => "whole number".into(),
        Some("string") => "text".into(),
        Some("array") => match node["minItems"].as_u64().filter(|n| node["maxItems"].as_u64() == Some(*n)) {
            Some(n) => format!("[{}; {n}]", takes(schema, &node["items"])),
            None => format!("[{}, ..]", takes(schema, &node["items"])),
        },
        Some(kind) => kind.to_string(),
        None => "value".into(),
    }
}

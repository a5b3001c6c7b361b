//! Examples of names in a case.

use freepath_harness::case::KINDS;
use freepath_harness::case::example::value;
use serde_json::{Value, json};

/// A line of a case that uses `name`; empty for a claim, which is withdrawn in a list.
pub(super) fn of(schema: &Value, kind: &str, name: &str, body: &Value) -> String {
    let used = match (kind, name) {
        _ if body.is_null() => json!(name),
        ("majorant", "factor") => json!({ name: 1.5 }),
        ("medium", "formula") => json!({ name: { "mu": "0.5 + t", "length": 2, "majorant": 2.5 } }),
        ("medium", "table") => json!({ name: { "file": "mu.csv", "interpolation": "linear" } }),
        (_, "samples") => json!({ name: { "file": "samples.csv" } }),
        (_, "command") => json!({ name: { "argv": ["python3", "mine.py"] } }),
        _ => json!({ name: value(schema, name, body) }),
    };
    match kind {
        kind if KINDS.iter().any(|known| known.name == kind) => spaced(&json!({ kind: used })),
        "claim" => format!("\"without\": [\"{name}\"]"),
        "agreement" => format!("\"agree\": [\"{name}\"]"),
        _ => format!("\"{kind}\": {}", spaced(&used)),
    }
}

/// `value` on one line, with spaces as people write it.
fn spaced(value: &Value) -> String {
    match value {
        Value::Object(fields) if fields.is_empty() => "{}".into(),
        Value::Object(fields) => {
            let fields: Vec<_> =
                fields.iter().map(|(name, value)| format!("\"{name}\": {}", spaced(value))).collect();
            format!("{{ {} }}", fields.join(", "))
        }
        Value::Array(items) => {
            let items: Vec<_> = items.iter().map(spaced).collect();
            format!("[{}]", items.join(", "))
        }
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => value.to_string(),
    }
}

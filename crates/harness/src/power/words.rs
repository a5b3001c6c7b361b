//! Faults and media in words: a name and its parameters.

use serde::Serialize;
use serde_json::Value;

/// Most elements of an array that are shown.
const MOST_ELEMENTS: usize = 8;

/// `value`, as it stands in a case, in words: `{"constant": {"mu": 1}}` is `constant mu=1`.
pub(super) fn words(value: &impl Serialize) -> String {
    text(&serde_json::to_value(value).unwrap_or_default())
}

fn text(value: &Value) -> String {
    match value {
        Value::Object(fields) => fields.iter().map(named).collect::<Vec<_>>().join(" "),
        Value::Array(values) => array(values),
        Value::String(word) => word.clone(),
        Value::Number(number) => number.as_f64().map_or_else(|| number.to_string(), short),
        Value::Null | Value::Bool(_) => value.to_string(),
    }
}

/// Without trailing zeros, and small numbers with an exponent.
fn short(x: f64) -> String {
    if x != 0.0 && x.abs() < 1e-3 { format!("{x:e}") } else { x.to_string() }
}

/// A variant with its parameters, or nested ones in brackets.
fn named((name, body): (&String, &Value)) -> String {
    match body {
        Value::Object(fields) if fields.is_empty() => name.clone(),
        Value::Object(fields) => format!("{name} {}", fields.iter().map(field).collect::<Vec<_>>().join(" ")),
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) | Value::Array(_) => {
            format!("{name} {}", text(body))
        }
    }
}

fn field((name, body): (&String, &Value)) -> String {
    let text = text(body);
    if body.is_object() { format!("{name}=({text})") } else { format!("{name}={text}") }
}

fn array(values: &[Value]) -> String {
    let shown: Vec<_> = values.iter().take(MOST_ELEMENTS).map(text).collect();
    let rest = if values.len() > MOST_ELEMENTS { ",.." } else { "" };
    format!("[{}{rest}]", shown.join(","))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn parameters_follow_their_name() {
        assert_eq!(words(&json!({ "short_majorant": { "factor": 0.9 } })), "short_majorant factor=0.9");
        assert_eq!(words(&json!({ "stale_position": {} })), "stale_position");
        assert_eq!(words(&json!({ "cut": { "below": 1e-5 } })), "cut below=1e-5");
        let nested = json!({ "reversed": { "medium": { "constant": { "length": 2.0, "mu": 1.5 } } } });
        assert_eq!(words(&nested), "reversed medium=(constant length=2 mu=1.5)");
        assert_eq!(words(&json!({ "x": { "edges": [0, 1], "rule": "left" } })), "x edges=[0,1] rule=left");
    }
}

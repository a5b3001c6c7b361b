//! Steps through the schema of a case.

use serde_json::Value;

/// The definition that a `$ref` refers to.
#[must_use]
pub fn resolve<'a>(schema: &'a Value, node: &'a Value) -> &'a Value {
    let target = node["$ref"].as_str().and_then(|to| to.strip_prefix('#'));
    target.and_then(|to| schema.pointer(to)).unwrap_or(node)
}

/// The names that an enum allows, with the schema of what follows the name, and the words.
#[must_use]
pub fn variants<'a>(schema: &'a Value, node: &'a Value) -> Vec<(&'a str, &'a Value, &'a str)> {
    let node = resolve(schema, node);
    let words = |node: &'a Value| node["description"].as_str().unwrap_or("");
    if let Some(choices) = node["oneOf"].as_array().or_else(|| node["anyOf"].as_array()) {
        return choices.iter().flat_map(|choice| variants(schema, choice)).collect();
    }
    if let Some(name) = node["const"].as_str() {
        return vec![(name, &Value::Null, words(node))];
    }
    if let Some(names) = node["enum"].as_array() {
        let names = names.iter().filter_map(Value::as_str);
        return names.map(|name| (name, &Value::Null, "")).collect();
    }
    let Some((name, body)) = node["properties"].as_object().and_then(|all| all.iter().next()) else {
        return Vec::new();
    };
    let body = resolve(schema, body);
    let own = words(node);
    vec![(name, body, if own.is_empty() { words(body) } else { own })]
}

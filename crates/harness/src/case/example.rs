//! The simplest value of a definition in the schema: the example that it states, else required parameters only, and those of a grid
//! that only some files and cases know.

use super::schema::{resolve, variants};
use serde_json::{Map, Value, json};

/// The value for what `node` describes, by its name where the name is known, else by its type.
#[must_use]
pub fn value(schema: &Value, name: &str, node: &Value) -> Value {
    if node["$ref"] == "#/$defs/AnyMedium" {
        return json!({ "gaussian": { "peak": 4.0, "center": 0.9, "width": 0.25, "length": 2.0 } });
    }
    let own = &node["examples"][0];
    let node = resolve(schema, node);
    if let Some(example) = [own, &node["examples"][0]].into_iter().find(|example| !example.is_null()) {
        return example.clone();
    }
    if let Some(properties) = node["properties"].as_object() {
        let required = node["required"].as_array().into_iter().flatten().filter_map(Value::as_str);
        let grid = properties.contains_key("bounds");
        let of_grid = ["bounds", "origin", "direction"].into_iter().filter(|_| grid);
        let fields =
            required.chain(of_grid).map(|field| (field.to_string(), value(schema, field, &properties[field])));
        return Value::Object(fields.collect::<Map<_, _>>());
    }
    if let Some((first, body, _)) = variants(schema, node).into_iter().next() {
        return if body.is_null() { json!(first) } else { json!({ first: value(schema, first, body) }) };
    }
    if name == "mu" && node["type"] == "string" {
        return json!("0.5 - 0.1*t"); // a formula, below the majorant of one half
    }
    by_name(name).unwrap_or_else(|| by_type(node))
}

fn by_type(node: &Value) -> Value {
    match node["type"].as_str() {
        Some("integer") => json!(8),
        Some("number") => json!(0.5),
        Some("string") => json!("text"),
        Some("array") => json!([0.5]),
        _ => json!({}),
    }
}

/// Values that suit one another.
fn by_name(name: &str) -> Option<Value> {
    Some(match name {
        "length" => json!(2.0),
        "mu" | "mean" => json!(1.5),
        "mu0" | "base" => json!(0.5),
        "mu1" | "scale_height" | "by" => json!(1.25),
        "peak" => json!(4.0),
        "center" | "to" | "end" => json!(0.9),
        "width" | "start" | "from" => json!(0.25),
        "constant" => json!(6.0),
        "edges" => json!([0.0, 0.75, 2.0]),
        "nodes" => json!([0.0, 2.0]),
        "ends" => json!([0.75, 2.0]),
        "values" | "mu_bar" => json!([3.0, 5.0]),
        "sigma_t" => json!([2.0, 1.0, 0.5]),
        "sigma_s" => json!([1.5, 0.9, 0.1]),
        "file" => json!("data/volume.npy"),
        "bounds" => json!([[0.0, 0.0, 0.0], [4.0, 3.0, 2.0]]),
        "origin" => json!([-1.0, 1.25, 0.75]),
        "direction" => json!([1.0, 0.25, 0.125]),
        "factor" => json!(0.8),
        "times" => json!(2.0),
        "along" => json!(-1.0),
        "channel" | "walk" => json!(0),
        "of" => json!(1000),
        "share" => json!(0.01),
        _ => return None,
    })
}

//! Kinds of values in the words of JSON, instead of those of Rust.

use serde::de::{Expected, Unexpected};

use crate::diagnose::words::shortened;

/// The words for a value found: `the string "x"`, `a list`.
pub(super) fn found(unexpected: Unexpected) -> String {
    match unexpected {
        Unexpected::Str(text) => format!("the string {:?}", shortened(text)),
        Unexpected::Bool(value) => value.to_string(),
        Unexpected::Unsigned(value) => value.to_string(),
        Unexpected::Signed(value) => value.to_string(),
        Unexpected::Float(value) => format!("{value:?}"), // Display would write 1e300 in full
        Unexpected::Unit | Unexpected::Option => "null".to_owned(),
        Unexpected::Seq => "a list".to_owned(),
        Unexpected::Map => "an object".to_owned(),
        other @ (Unexpected::Char(_)
        | Unexpected::Bytes(_)
        | Unexpected::NewtypeStruct
        | Unexpected::Enum
        | Unexpected::UnitVariant
        | Unexpected::NewtypeVariant
        | Unexpected::TupleVariant
        | Unexpected::StructVariant
        | Unexpected::Other(_)) => other.to_string(),
    }
}

/// The words for a wanted type: `a number` for an f64.
pub(super) fn wanted(expected: &dyn Expected) -> String {
    let rust = expected.to_string();
    let words = match rust.as_str() {
        "f64" | "f32" => "a number",
        "u64" | "usize" => "a whole number, not negative",
        "i64" | "isize" => "a whole number",
        "a boolean" => "true or false",
        "a sequence" => "a list",
        "a map" => "an object",
        "unit" => "null",
        struct_like if struct_like.starts_with("struct ") => "an object",
        other => return integer(other).or_else(|| list(other)).unwrap_or(rust),
    };
    words.to_owned()
}

fn integer(rust: &str) -> Option<String> {
    let (least, most) = match rust {
        "u8" => (0, i64::from(u8::MAX)),
        "u16" => (0, i64::from(u16::MAX)),
        "u32" => (0, i64::from(u32::MAX)),
        "i8" => (i64::from(i8::MIN), i64::from(i8::MAX)),
        "i16" => (i64::from(i16::MIN), i64::from(i16::MAX)),
        "i32" => (i64::from(i32::MIN), i64::from(i32::MAX)),
        _ => return None,
    };
    Some(format!("a whole number from {least} to {most}"))
}

/// Arrays and tuples name their length in one way or another: it is the only number there.
fn list(rust: &str) -> Option<String> {
    let is_list = ["an array of length", "a tuple of size", "tuple struct", "tuple variant"];
    if !is_list.iter().any(|start| rust.starts_with(start)) {
        return None;
    }
    let length: usize = rust.split(' ').rev().find_map(|word| word.parse().ok())?;
    Some(format!("a list of {length} {}", if length == 1 { "value" } else { "values" }))
}

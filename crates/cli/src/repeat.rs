//! The words of a command that repeats results.

use freepath_harness::run::quoted;

/// A flag and its value, as a shell takes them.
pub(crate) fn flag(name: &str, value: &str) -> String {
    format!("--{name} {}", quoted(value))
}

/// The name of a value, as a case has it.
pub(crate) fn name(value: &impl serde::Serialize) -> String {
    let json = serde_json::to_value(value).unwrap_or_default();
    json.as_str().unwrap_or_default().to_string()
}

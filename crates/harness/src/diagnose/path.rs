//! The way from the whole file to one value.

use std::fmt;

use super::words::shortened;

/// One step from a value to a value in it. It is written as it stands inside a path: `.medium`, `[2]`, `["odd key"]`.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Step {
    Key(String),
    Index(usize),
}

impl fmt::Display for Step {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Step::Key(key) if is_plain(key) => write!(f, ".{}", shortened(key)),
            Step::Key(key) => write!(f, "[{:?}]", shortened(key)),
            Step::Index(index) => write!(f, "[{index}]"),
        }
    }
}

fn is_plain(key: &str) -> bool {
    !key.is_empty() && key.chars().all(|c| c.is_ascii_alphanumeric() || "_-$".contains(c))
}

/// A whole path as it is written: `subjects[2].free_path`, and nothing for the whole file.
pub(super) fn written(path: &[Step]) -> String {
    let steps: String = path.iter().map(Step::to_string).collect();
    steps.strip_prefix('.').unwrap_or(&steps).to_owned()
}

/// A written path, and one that goes on from its end.
pub(super) fn joined(path: &str, rest: &str) -> String {
    let dot = if path.is_empty() || rest.is_empty() || rest.starts_with('[') { "" } else { "." };
    format!("{path}{dot}{rest}")
}

/// The name of the value at the end of `path`: `edges[2]`, or `the file` for the whole.
pub(super) fn last_name(path: &[Step]) -> String {
    let from = path.iter().rposition(|step| matches!(step, Step::Key(_))).unwrap_or(0);
    match path.get(from..) {
        Some(steps) if !steps.is_empty() => written(steps),
        _ => "the file".to_owned(),
    }
}

//! The name of the command.

use std::sync::OnceLock;

/// Set once, by the command that runs.
static NAME: OnceLock<&str> = OnceLock::new();

/// Makes `name` its name from now on; the first one stays.
pub(crate) fn set(name: &'static str) {
    NAME.get_or_init(|| name);
}

/// The name, for messages and for commands that repeat results.
pub(crate) fn get() -> &'static str {
    NAME.get().copied().unwrap_or("freepath")
}

//! What the program is called.

use std::sync::OnceLock;

/// Set once, by the command that runs.
static NAME: OnceLock<&str> = OnceLock::new();

/// Calls it `name` from now on.
pub(crate) fn call(name: &'static str) {
    NAME.get_or_init(|| name);
}

/// Its name, for messages and for commands that repeat results.
pub(crate) fn name() -> &'static str {
    NAME.get().copied().unwrap_or("freepath")
}

//! The standard error of programs.

use std::sync::{Mutex, PoisonError};

/// The most bytes that are kept of a program's standard error.
pub(crate) const MOST_LOG: usize = 64 << 10;

/// The beginning of what was said.
#[derive(Default)]
pub(super) struct Log(Mutex<Vec<u8>>);

impl Log {
    /// Keeps what there is room for.
    pub(super) fn add(&self, said: &[u8]) {
        let mut kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let room = MOST_LOG - kept.len();
        kept.extend_from_slice(&said[..if said.len() < room { said.len() } else { room }]);
    }

    /// All of it, as text.
    pub(super) fn text(&self) -> String {
        String::from_utf8_lossy(&self.0.lock().unwrap_or_else(PoisonError::into_inner)).into_owned()
    }
}

/// The last line of `said` that says something, cut to one line of a message; controls are left out.
pub(super) fn last_line(said: &[u8]) -> Option<String> {
    let text = String::from_utf8_lossy(said);
    let line = text.lines().rev().find(|line| !line.trim().is_empty())?;
    Some(line.trim().chars().filter(|c| !c.is_control()).take(200).collect())
}

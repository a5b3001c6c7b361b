//! `freepath list`.

use crate::args::List;
use crate::command_error::CommandError;
use crate::reference::{Entry, entries, page};
use crate::screen;
use serde_json::{Value, json};

/// Prints every name with one sentence; in Markdown with its parameters, and with the details of tests.
pub(crate) fn list(args: &List) -> Result<u8, CommandError> {
    let entries = entries();
    if args.json {
        let line = |entry: &Entry| json!({ "kind": entry.kind, "name": entry.name, "summary": entry.summary() });
        screen::print_json(&Value::Array(entries.iter().map(line).collect()))?;
    } else if args.markdown {
        screen::print(&page(&entries))?;
    } else {
        screen::print(&text(&entries))?;
    }
    Ok(0)
}

fn text(entries: &[Entry]) -> String {
    let width = entries.iter().map(|entry| entry.name.len()).max().unwrap_or(0);
    let (mut text, mut kind) = (String::new(), "");
    for entry in entries {
        if entry.kind != kind {
            let gap = if kind.is_empty() { "" } else { "\n" };
            text += &format!("{gap}{}\n", entry.kind);
            kind = entry.kind;
        }
        text += &format!("  {:width$}  {}\n", entry.name, entry.summary());
    }
    text
}

//! All names as a page in Markdown: `docs/reference.md`.

use super::{Entry, Field};

const HEAD: &str = "\
# Reference

<!-- Made by `freepath list --markdown`: a test fails while it is not current. -->

Every name that a case can use, and every test, check and reason, by kind. `freepath describe NAME` says more of each;
[statistics.md](statistics.md) explains tests, checks and reasons at length, [faults.md](faults.md) the faults.
";

/// The page of `entries`, which stand by kind.
pub(crate) fn page(entries: &[Entry]) -> String {
    let (mut page, mut kind) = (HEAD.to_string(), "");
    for entry in entries {
        if entry.kind != kind {
            kind = entry.kind;
            page += &format!("\n## {kind}\n");
        }
        page += &section(entry);
    }
    page
}

fn section(entry: &Entry) -> String {
    let mut section = format!("\n### `{}`\n\n{}\n", entry.name, entry.summary());
    section += &match &entry.fields[..] {
        [] => String::new(),
        [value] if value.name.is_empty() => format!("\nTakes: {}\n", cell(&value.takes)),
        fields => format!("\n| parameter | takes | default | |\n|---|---|---|---|\n{}", rows(fields)),
    };
    if let Some(told) = &entry.told {
        section += &format!("\n```text\n{}\n```\n\n[More](statistics.md#{})\n", told.details, told.section);
    }
    section
}

fn rows(fields: &[Field]) -> String {
    let default = |field: &Field| field.default.as_ref().map_or("required".into(), |value| format!("`{value}`"));
    let row = |field: &Field| {
        format!("| `{}` | {} | {} | {} |\n", field.name, cell(&field.takes), default(field), cell(&field.words))
    };
    fields.iter().map(row).collect()
}

/// `text` in a cell of a table.
fn cell(text: &str) -> String {
    text.replace('|', "\\|")
}

//! `freepath describe`.

use crate::args::Describe;
use crate::command_error::CommandError;
use crate::reference::{Entry, Field, entries};
use crate::{command_name, screen};
use freepath_statistics::hypothesis::family;

/// Prints all that is known of a name; of each, if it names several things. A test goes by the names of its claims as well:
/// `own_atom`, `scatter_0`.
pub(crate) fn describe(args: &Describe) -> Result<u8, CommandError> {
    let entries = entries();
    let known = entries.iter().any(|entry| entry.name == args.name);
    let name = if known { args.name.as_str() } else { family(&args.name) };
    let found: Vec<_> = entries.iter().filter(|entry| entry.name == name).map(text).collect();
    if found.is_empty() {
        return Err(unknown(&args.name, &entries));
    }
    screen::print(&found.join("\n"))?;
    Ok(0)
}

fn text(entry: &Entry) -> String {
    let mut text = format!("{} ({})\n\n", entry.name, entry.kind);
    text += &entry.words;
    text.push('\n');
    text += &match &entry.fields[..] {
        [] => String::new(),
        [value] if value.name.is_empty() => format!("\nTakes\n  {}\n", value.takes),
        fields => format!("\nFields\n{}", table(fields)),
    };
    if !entry.example.is_empty() {
        text += &format!("\nExample\n  {}\n", entry.example);
    }
    text
}

fn table(fields: &[Field]) -> String {
    let default = |field: &Field| match &field.default {
        Some(default) => format!("default {default}"),
        None => "required".into(),
    };
    let width = |of: &dyn Fn(&Field) -> usize| fields.iter().map(of).max().unwrap_or(0);
    let names = width(&|field| field.name.len());
    let types = width(&|field| field.takes.len());
    let defaults = width(&|field| default(field).len());
    let line = |field: &Field| {
        let (name, takes, words, default) = (&field.name, &field.takes, &field.words, default(field));
        format!("  {name:names$}  {takes:types$}  {default:defaults$}  {words}\n")
    };
    fields.iter().map(line).collect()
}

fn unknown(name: &str, entries: &[Entry]) -> CommandError {
    let near = entries.iter().map(|entry| (strsim::damerau_levenshtein(name, &entry.name), &entry.name));
    let nearest = near.min().filter(|(distance, _)| *distance <= name.chars().count().div_ceil(3));
    let hint = nearest.map(|(_, near)| format!("did you mean `{near}`? ")).unwrap_or_default();
    let name = screen::cell(name, 60);
    CommandError::unusable(format!(
        "cannot describe `{name}`: there is no such name ({hint}`{} list` shows all)",
        command_name::get()
    ))
}

//! From the text of a case file to a typed value, or to one message about one place of the file.
//!
//! The text is JSON with comments and trailing commas. Every value remembers where it stands, so the
//! message of a misspelt name, a wrong type or a refused parameter underlines what is to be changed:
//!
//! ```
//! use freepath_harness::diagnose;
//!
//! #[derive(Debug, serde::Deserialize)]
//! #[serde(deny_unknown_fields)]
//! struct Case {
//!     draws: u64,
//! }
//!
//! let case: Case = diagnose::parse("demo.json", r#"{ "draws": 1e6 } // a million"#).unwrap();
//! assert_eq!(case.draws, 1_000_000);
//!
//! let misspelt = diagnose::parse::<Case>("demo.json", r#"{ "drawz": 1e6 }"#).unwrap_err();
//! assert_eq!((misspelt.line(), misspelt.column()), (1, 3));
//! assert!(misspelt.to_string().contains("did you mean `draws`?"));
//! ```

mod decode;
mod diagnosis;
mod excerpt;
mod misfit;
mod path;
mod syntax;
mod tree;
mod words;

#[cfg(test)]
mod tests;

use serde::de::DeserializeOwned;

pub use diagnosis::Diagnosis;
use diagnosis::Finding;
use path::joined;
use tree::{Node, Value};

/// The longest text that is read, in bytes. Compare a file's size with it before reading the file.
pub const MAX_BYTES: usize = 16 << 20;

/// The deepest nesting of objects and lists that is read.
pub const MAX_DEPTH: usize = 64;

/// Reads `text` as a `T`. `file` is the name to show in messages; it is not opened.
///
/// # Errors
///
/// The first thing that is wrong with the text.
pub fn parse<T: DeserializeOwned>(file: &str, text: &str) -> Result<T, Diagnosis> {
    Source::new(file, text)?.read()
}

/// The text of a file with the place of every value in it.
///
/// Keep it beside the value that was read from it: what only turns out later can still be shown at its place.
#[derive(Debug)]
pub struct Source {
    file: String,
    text: String,
    root: Node,
}

impl Source {
    /// Checks the syntax of `text`. `file` is the name to show in messages; it is not opened.
    ///
    /// # Errors
    ///
    /// A text that is no JSON (with comments and trailing commas), is longer than [`MAX_BYTES`] or nests deeper than
    /// [`MAX_DEPTH`], names a key twice in one object, or holds a number beyond the range of an `f64`.
    pub fn new(file: impl Into<String>, text: impl Into<String>) -> Result<Source, Diagnosis> {
        let (file, text) = (file.into(), without_mark(text.into()));
        match syntax::parse(&text) {
            Ok(root) => Ok(Source { file, text, root }),
            Err(fault) => Err(Diagnosis::new(&file, &text, &cannot_read(fault))),
        }
    }

    /// Reads the text as a `T`.
    ///
    /// # Errors
    ///
    /// The first place that does not fit `T`.
    pub(crate) fn read<T: DeserializeOwned>(&self) -> Result<T, Diagnosis> {
        self.read_at("")
    }

    /// Reads the value at `path` as a `T`; `path` as in [`Source::diagnose`].
    ///
    /// # Errors
    ///
    /// The first place that does not fit `T`.
    pub(crate) fn read_at<T: DeserializeOwned>(&self, path: &str) -> Result<T, Diagnosis> {
        let node = self.root.find(path);
        T::deserialize(node).map_err(|misfit| {
            let found = misfit.locate(node);
            self.finding(&cannot_read(Finding { path: joined(path, &found.path), ..found }))
        })
    }

    /// The key of the object at `path`, if it has one key.
    pub(crate) fn only_key(&self, path: &str) -> Option<&str> {
        let Value::Object(members) = &self.root.find(path).value else { return None };
        match members.as_slice() {
            [member] => Some(member.key.text()),
            [] | [_, ..] => None,
        }
    }

    /// A message about the value at `path`, which is written as messages write it:
    /// `subjects[2].free_path.ray_marching.steps`, and `""` for the whole file. Of a path that leaves the file, such
    /// as one to a field left at its default, the innermost value that is there is shown.
    pub fn diagnose(&self, path: &str, message: impl Into<String>) -> Diagnosis {
        let span = self.root.find(path).span.clone();
        self.finding(&Finding { span, path: path.to_owned(), message: message.into() })
    }

    fn finding(&self, finding: &Finding) -> Diagnosis {
        Diagnosis::new(&self.file, &self.text, finding)
    }
}

fn cannot_read(cause: Finding) -> Finding {
    Finding { message: format!("cannot read the case: {}", cause.message), ..cause }
}

/// The text without the byte order mark that some editors put first.
fn without_mark(text: String) -> String {
    match text.strip_prefix('\u{feff}') {
        Some(rest) => rest.to_owned(),
        None => text,
    }
}

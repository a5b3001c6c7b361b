//! A small case format, and what becomes of texts in it.

mod hostile;
mod messages;
mod syntax;

use serde::Deserialize;

use super::{Diagnosis, MAX_BYTES, MAX_DEPTH, Source, parse};

#[derive(Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct Case {
    title: Option<String>,
    medium: Medium,
    #[serde(default)]
    majorant: Majorant,
    #[serde(default)]
    draws: u64,
}

#[derive(Debug, Default, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
enum Majorant {
    #[default]
    Tight,
    Constant(f64),
    Segments(u8),
}

#[derive(Debug, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
enum Medium {
    Constant(Constant),
    Gaussian { peak: f64, width: f64 },
    Piecewise { edges: Vec<f64>, bounds: [f64; 2] },
}

#[derive(Debug, PartialEq, Deserialize)]
#[serde(try_from = "Parameters")]
struct Constant {
    mu: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Parameters {
    mu: f64,
    #[serde(default)]
    note: String,
}

impl TryFrom<Parameters> for Constant {
    type Error = String;

    fn try_from(Parameters { mu, note }: Parameters) -> Result<Constant, String> {
        match note.as_str() {
            "" if mu >= 0.0 => Ok(Constant { mu }),
            "" => Err(format!("mu must be finite and not negative, not {mu}")),
            note => Err(format!("no constant medium is called {note}")),
        }
    }
}

fn refused(text: &str) -> Diagnosis {
    parse::<Case>("cases/demo.json", text).unwrap_err()
}

/// Compares the whole rendered message.
#[track_caller]
fn assert_says(text: &str, rendered: &[&str]) {
    let lines: Vec<String> = refused(text).to_string().lines().map(str::to_owned).collect();
    assert_eq!(lines, rendered, "got:\n{}", lines.join("\n"));
}

/// Compares the message alone, and what is underlined.
#[track_caller]
fn assert_blames(text: &str, underlined: &str, message: &str) {
    let refused = refused(text);
    assert_eq!(refused.message(), format!("cannot read the case: {message}"));
    let excerpt = refused.excerpt();
    assert_eq!(&excerpt.text[excerpt.underlined.clone()], underlined);
}

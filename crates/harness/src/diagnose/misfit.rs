//! The misfit of a tree to the value that was asked for, and its place.

use std::fmt;

use serde::de::{Error, Expected, Unexpected};

use super::diagnosis::Finding;
use super::path::{Step, last_name, written};
use super::tree::Node;
use super::words::unknown;

mod kinds;

/// The misfit of a tree to the value that was asked for. The path grows as the error leaves the values it occurred in.
#[derive(Debug)]
pub(super) struct Misfit {
    cause: Cause,
    spot: Spot,
    inner_first: Vec<Step>,
}

#[derive(Debug)]
enum Cause {
    /// A sentence of its own.
    Sentence(String),
    /// A sentence whose subject is the value at the path.
    Predicate(String),
}

/// The part to underline.
#[derive(Debug)]
enum Spot {
    Value,
    /// A key of the object.
    Key(String),
    /// The field that the sentence begins with, if the object has it.
    Named,
}

impl Misfit {
    /// An error about the value itself, in a sentence.
    pub(super) fn sentence(text: String) -> Misfit {
        Misfit { cause: Cause::Sentence(text), spot: Spot::Value, inner_first: Vec::new() }
    }

    /// An error about the value itself, which is the subject of the sentence.
    pub(super) fn predicate(text: String) -> Misfit {
        Misfit { cause: Cause::Predicate(text), spot: Spot::Value, inner_first: Vec::new() }
    }

    /// The same error, seen from one level further out.
    pub(super) fn under(mut self, step: Step) -> Misfit {
        self.inner_first.push(step);
        self
    }

    /// The same error, about a key of the object.
    pub(super) fn at_key(mut self, key: &Node) -> Misfit {
        self.spot = Spot::Key(key.text().to_owned());
        self
    }

    /// Finds the place in the tree that was read.
    pub(super) fn locate(self, root: &Node) -> Finding {
        let mut path: Vec<Step> = self.inner_first.into_iter().rev().collect();
        let node = root.walk(&path);
        let span = match self.spot {
            Spot::Value => None,
            Spot::Key(key) => node.member(&key).map(|member| &member.key.span),
            Spot::Named => match &self.cause {
                Cause::Sentence(text) => node.member(first_name(text)).map(|member| {
                    path.push(Step::Key(member.key.text().to_owned()));
                    &member.value.span
                }),
                Cause::Predicate(_) => None,
            },
        };
        let span = span.unwrap_or(&node.span).clone();
        let message = match self.cause {
            Cause::Sentence(text) => text,
            Cause::Predicate(text) => format!("{} {text}", last_name(&path)),
        };
        Finding { span, path: written(&path), message }
    }
}

/// The identifier at the beginning of a sentence.
fn first_name(text: &str) -> &str {
    text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').next().unwrap_or_default()
}

impl Error for Misfit {
    fn custom<T: fmt::Display>(message: T) -> Misfit {
        Misfit { spot: Spot::Named, ..Misfit::sentence(message.to_string()) }
    }

    fn invalid_type(unexpected: Unexpected, expected: &dyn Expected) -> Misfit {
        Misfit::predicate(format!("is {} (must be {})", kinds::found(unexpected), kinds::wanted(expected)))
    }

    fn invalid_value(unexpected: Unexpected, expected: &dyn Expected) -> Misfit {
        Misfit::invalid_type(unexpected, expected)
    }

    fn invalid_length(length: usize, expected: &dyn Expected) -> Misfit {
        let values = if length == 1 { "value" } else { "values" };
        Misfit::predicate(format!("has {length} {values} (must be {})", kinds::wanted(expected)))
    }

    fn unknown_variant(name: &str, allowed: &'static [&'static str]) -> Misfit {
        Misfit::sentence(unknown("name", name, allowed))
    }

    fn unknown_field(name: &str, allowed: &'static [&'static str]) -> Misfit {
        Misfit::sentence(unknown("field", name, allowed))
    }

    fn missing_field(name: &'static str) -> Misfit {
        Misfit::sentence(format!("missing field `{name}`"))
    }
}

impl fmt::Display for Misfit {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match &self.cause {
            Cause::Sentence(text) => f.write_str(text),
            Cause::Predicate(text) => write!(f, "the value {text}"),
        }
    }
}

impl std::error::Error for Misfit {}

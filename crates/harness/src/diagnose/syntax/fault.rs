//! A fault in the grammar of a text.

use std::ops::Range;

use jsonc_parser::ParseStringErrorKind;
use jsonc_parser::errors::{ParseError, ParseErrorKind};

use crate::diagnose::diagnosis::Finding;
use crate::diagnose::path::{Step, written};

/// A fault in the text, and its place. The path grows as the fault leaves the values it occurred in.
#[derive(Debug)]
pub(super) struct Fault {
    span: Range<usize>,
    message: String,
    inner_first: Vec<Step>,
}

impl Fault {
    pub(super) fn new(span: Range<usize>, message: impl Into<String>) -> Fault {
        Fault { span, message: message.into(), inner_first: Vec::new() }
    }

    /// A string that goes on where its line ends.
    pub(super) fn no_quote(span: Range<usize>) -> Fault {
        Fault::new(span, "the string does not end on its line (`\"` is missing)")
    }

    /// The same fault, seen from one level further out.
    pub(super) fn under(mut self, step: Step) -> Fault {
        self.inner_first.push(step);
        self
    }
}

impl From<Fault> for Finding {
    fn from(fault: Fault) -> Finding {
        let path: Vec<Step> = fault.inner_first.into_iter().rev().collect();
        Finding { span: fault.span, path: written(&path), message: fault.message }
    }
}

impl From<ParseError> for Fault {
    fn from(error: ParseError) -> Fault {
        let span = error.range().start..error.range().end;
        let kind = error.kind();
        if let ParseErrorKind::String(ParseStringErrorKind::UnterminatedStringLiteral) = kind {
            return Fault::no_quote(span);
        }
        Fault::new(span, lower_case(&kind.to_string()))
    }
}

/// A sentence as our messages have it: without its capital.
fn lower_case(sentence: &str) -> String {
    let mut letters = sentence.chars();
    let first = letters.next().map(|c| c.to_ascii_lowercase());
    first.into_iter().chain(letters).collect()
}

//! The line around a place, fit to be printed.

use std::ops::Range;

use super::words::is_invisible;

/// The longest line that is shown whole, in characters, and what is kept of a longer one before and after the place.
const LONGEST: usize = 160;
const BEFORE: usize = 60;
const AFTER: usize = LONGEST - BEFORE - 2 * CUT.len();
const CUT: &str = "...";

/// A place of a text: line and column from 1, columns in characters, and its line with the part to underline.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Excerpt {
    pub(super) line: usize,
    pub(super) column: usize,
    pub(super) text: String,
    pub(super) underlined: Range<usize>,
}

impl Excerpt {
    /// The place `span` of `text`. Of a span over several lines, the first is shown.
    pub(super) fn new(text: &str, span: &Range<usize>) -> Excerpt {
        let (head, tail) = text.split_at(text.floor_char_boundary(span.start));
        let before = head.rsplit('\n').next().unwrap_or_default();
        let after = tail.split('\n').next().unwrap_or_default().trim_end();
        let width = after.floor_char_boundary(span.end.saturating_sub(span.start));
        let (underlined, rest) = after.split_at(width);
        let (text, underlined) = cut([before, underlined, rest]);
        Excerpt { line: line_of(head), column: before.chars().count() + 1, text, underlined }
    }
}

/// The line, from 1, on which `head` ends.
pub(super) fn line_of(head: &str) -> usize {
    head.matches('\n').count() + 1
}

/// Puts the parts of a line together, without its ends if it is long, and says where the middle part is.
fn cut([before, underlined, rest]: [&str; 3]) -> (String, Range<usize>) {
    let long = [before, underlined, rest].into_iter().flat_map(str::chars).nth(LONGEST).is_some();
    let (left, right) = if long { (BEFORE, AFTER) } else { (LONGEST, LONGEST) };
    let hidden = before.chars().count().saturating_sub(left);
    let mut line = if hidden > 0 { CUT.to_owned() } else { String::new() };
    line.extend(before.chars().skip(hidden).map(visible));
    let start = line.len();
    line.extend(underlined.chars().take(right).map(visible));
    let end = line.len();
    let shown = underlined.chars().take(right).count();
    line.extend(rest.chars().take(right - shown).map(visible));
    if underlined.chars().chain(rest.chars()).nth(right).is_some() {
        line.push_str(CUT);
    }
    (line, start..end)
}

/// A character of the excerpt: as wide as it looks, and without effect on the terminal.
fn visible(c: char) -> char {
    match c {
        '\t' => ' ',
        c if is_invisible(c) => char::REPLACEMENT_CHARACTER,
        c => c,
    }
}

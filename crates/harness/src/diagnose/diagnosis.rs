//! One message about one place of one file.

use std::fmt;
use std::ops::Range;

use annotate_snippets::renderer::{DEFAULT_LINE_NUM_STYLE, Style};
use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};

use super::excerpt::Excerpt;
use super::words::{cut, escaped};

/// Excerpts are cut before they are rendered, so the renderer need not cut them.
const WIDTH: usize = 1000;

/// A type may put a text of the file into its message, so messages are cut too, in characters.
const LONGEST_MESSAGE: usize = 2000;

/// A message about one place of one file.
///
/// `Display` and [`Diagnosis::render`] show the message, the place and the line that is meant.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnosis(Box<Parts>);

#[derive(Clone, Debug, PartialEq)]
struct Parts {
    file: String,
    message: String,
    path: String,
    excerpt: Excerpt,
}

/// A mistake, and its place.
#[derive(Debug)]
pub(super) struct Finding {
    pub(super) span: Range<usize>,
    pub(super) path: String,
    pub(super) message: String,
}

impl Diagnosis {
    pub(super) fn new(file: &str, text: &str, finding: &Finding) -> Diagnosis {
        Diagnosis(Box::new(Parts {
            file: escaped(file),
            message: escaped(&cut(&finding.message, LONGEST_MESSAGE)),
            path: escaped(&finding.path),
            excerpt: Excerpt::new(text, &finding.span),
        }))
    }

    /// The message alone, on one line, without the place.
    #[must_use]
    pub(crate) fn message(&self) -> &str {
        &self.0.message
    }

    /// The file's name as it was given, control characters escaped.
    #[must_use]
    pub(crate) fn file(&self) -> &str {
        &self.0.file
    }

    /// The line of the place, from 1.
    #[must_use]
    pub fn line(&self) -> usize {
        self.excerpt().line
    }

    /// The column of the place, from 1, in characters.
    #[must_use]
    pub fn column(&self) -> usize {
        self.excerpt().column
    }

    /// The JSON path of the place, like `subjects[2].free_path`, and empty for the whole file.
    #[must_use]
    pub(crate) fn path(&self) -> &str {
        &self.0.path
    }

    pub(super) fn excerpt(&self) -> &Excerpt {
        &self.0.excerpt
    }

    /// The message, the place and the line with the place underlined, in colour if the terminal takes it.
    #[must_use]
    pub fn render(&self, color: bool) -> String {
        let excerpt = self.excerpt();
        let label = (!self.path().is_empty()).then(|| format!("at {}", self.path()));
        let annotation = AnnotationKind::Primary.span(excerpt.underlined.clone()).label(label);
        let snippet = Snippet::source(&*excerpt.text).line_start(excerpt.line);
        let report = Level::ERROR.primary_title(self.message()).element(snippet.annotation(annotation));
        let renderer = if color { Renderer::styled() } else { Renderer::plain() };
        let rendered = renderer.term_width(WIDTH).render(&[report]);
        match rendered.split_once('\n') {
            Some((title, lines)) => format!("{title}\n{}\n{lines}", self.origin(color)),
            None => rendered,
        }
    }

    /// The line that says where. The renderer would count the column in the excerpt, not in the file.
    fn origin(&self, color: bool) -> String {
        let (file, line, column) = (self.file(), self.line(), self.column());
        let indent = line.to_string().len();
        let style = if color { DEFAULT_LINE_NUM_STYLE } else { Style::new() };
        format!("{:indent$}{style}-->{style:#} {file}:{line}:{column}", "")
    }
}

impl fmt::Display for Diagnosis {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.render(false))
    }
}

impl std::error::Error for Diagnosis {}

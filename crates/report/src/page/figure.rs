//! A plot in the page.

use crate::ReportError;
use crate::draw::inline;
use crate::figures::Drawn;

/// A plot with its words.
pub(crate) struct FigureView {
    pub(crate) svg: String,
    pub(crate) heading: String,
    pub(crate) words: String,
    pub(crate) file: String,
}

impl FigureView {
    pub(crate) fn new(drawn: &Drawn) -> Result<Self, ReportError> {
        let figure = &drawn.figure;
        Ok(Self {
            svg: inline(&figure.picture)?,
            heading: figure.heading.clone(),
            words: figure.words.clone(),
            file: drawn.file.clone(),
        })
    }

    /// Those of a list.
    pub(crate) fn all(drawn: &[Drawn]) -> Result<Vec<Self>, ReportError> {
        drawn.iter().map(Self::new).collect()
    }
}

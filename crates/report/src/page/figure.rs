//! A plot in the page.

use crate::draw::inline;
use crate::figures::{Drawn, Figures};
use crate::site::{Site, Subject};

/// A plot with its words.
pub(crate) struct FigureView {
    pub(crate) svg: String,
    pub(crate) heading: String,
    /// What it shows; empty where `reading` tells it.
    pub(crate) words: String,
    /// The [`Reading`] that holds the words.
    pub(crate) reading: Option<&'static str>,
    pub(crate) file: String,
}

impl FigureView {
    fn new(drawn: &Drawn, readings: &[Reading]) -> Self {
        let figure = &drawn.figure;
        let reading = readings.iter().find(|r| r.name == figure.name && r.words == figure.words).map(|r| r.name);
        Self {
            svg: inline(&figure.picture),
            heading: figure.heading.clone(),
            words: if reading.is_some() { String::new() } else { figure.words.clone() },
            reading,
            file: drawn.file.clone(),
        }
    }

    /// Those of a list, each with its words.
    pub(crate) fn all(drawn: &[Drawn]) -> Vec<Self> {
        Self::told(drawn, &[])
    }

    /// Those of a list, without the words that `readings` tell.
    pub(crate) fn told(drawn: &[Drawn], readings: &[Reading]) -> Vec<Self> {
        drawn.iter().map(|drawn| Self::new(drawn, readings)).collect()
    }
}

/// How to read the plots of one kind, told once for all subjects that need no attention.
pub(crate) struct Reading {
    pub(crate) name: &'static str,
    pub(crate) heading: String,
    pub(crate) words: String,
}

impl Reading {
    /// One for each kind of plot that a quiet subject has.
    pub(crate) fn all(site: &Site, figures: &Figures) -> Vec<Self> {
        let mut readings: Vec<Self> = vec![];
        let quiet = site.subjects.iter().zip(&figures.subjects).filter(|(subject, _)| is_quiet(subject));
        for figure in quiet.flat_map(|(_, drawn)| drawn).map(|drawn| &drawn.figure) {
            if readings.iter().all(|reading| reading.name != figure.name) {
                let (heading, words) = (figure.heading.clone(), figure.words.clone());
                readings.push(Self { name: figure.name, heading, words });
            }
        }
        readings
    }
}

/// It is as expected: nothing about it needs an explanation beside it.
pub(crate) fn is_quiet(subject: &Subject) -> bool {
    subject.result.as_expected
}

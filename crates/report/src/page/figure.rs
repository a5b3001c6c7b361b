//! A plot in the page.

use crate::draw::inline;
use crate::figures::{Drawn, Figures};
use crate::site::{Site, Subject};
use std::collections::BTreeMap;

/// A plot with its words.
pub(crate) struct FigureView {
    pub(crate) svg: String,
    pub(crate) heading: String,
    /// Its meaning in words; empty where `reading` tells it.
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
        Self::with_readings(drawn, &[])
    }

    /// Those of a list, without the words that `readings` tell.
    pub(crate) fn with_readings(drawn: &[Drawn], readings: &[Reading]) -> Vec<Self> {
        drawn.iter().map(|drawn| Self::new(drawn, readings)).collect()
    }
}

/// A guide to the plots of one kind, told once for all subjects that need no attention.
pub(crate) struct Reading {
    pub(crate) name: &'static str,
    pub(crate) heading: String,
    pub(crate) words: String,
}

impl Reading {
    /// One for each kind of plot of which several have the same words, and half of them or more.
    pub(crate) fn all(site: &Site, figures: &Figures) -> Vec<Self> {
        let mut kinds: BTreeMap<&'static str, BTreeMap<&str, (usize, &str)>> = BTreeMap::new();
        let quiet = site.subjects.iter().zip(&figures.subjects).filter(|(subject, _)| is_quiet(subject));
        for Drawn { figure, .. } in quiet.flat_map(|(_, drawn)| drawn) {
            let words = kinds.entry(figure.name).or_default().entry(&figure.words);
            words.or_insert((0, &figure.heading)).0 += 1;
        }
        kinds.into_iter().filter_map(|(name, all)| Self::of(name, &all)).collect()
    }

    /// From how often each of the words stand under a kind of plot, and under which heading.
    fn of(name: &'static str, all: &BTreeMap<&str, (usize, &str)>) -> Option<Self> {
        let plots: usize = all.values().map(|(count, _)| count).sum();
        let (words, (count, heading)) = all.iter().max_by_key(|(_, (count, _))| count)?;
        let shared = *count > 1 && 2 * count >= plots;
        shared.then(|| Self { name, heading: (*heading).into(), words: (*words).into() })
    }
}

/// It is as expected: nothing about it needs an explanation beside it.
pub(crate) fn is_quiet(subject: &Subject) -> bool {
    subject.result.as_expected
}

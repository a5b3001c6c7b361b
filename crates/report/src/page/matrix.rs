//! Estimators against media: a letter for each verdict.

use super::words::{class, kind, letter};
use crate::site::{Site, Subject};
use crate::text::{clean, words};
use std::collections::BTreeMap;

/// Rows in groups, one column for each case.
pub(crate) struct Matrix {
    pub(crate) columns: Vec<Column>,
    pub(crate) groups: Vec<Group>,
}

pub(crate) struct Column {
    pub(crate) number: usize,
    pub(crate) id: String,
    pub(crate) short: String,
    pub(crate) title: String,
}

pub(crate) struct Group {
    pub(crate) name: String,
    pub(crate) rows: Vec<MatrixRow>,
}

pub(crate) struct MatrixRow {
    pub(crate) name: String,
    /// One for each column.
    pub(crate) cells: Vec<Vec<Letter>>,
}

#[derive(Clone)]
pub(crate) struct Letter {
    pub(crate) id: String,
    pub(crate) letter: &'static str,
    pub(crate) class: &'static str,
    pub(crate) surprising: bool,
    pub(crate) title: String,
}

impl Letter {
    pub(crate) fn new(subject: &Subject) -> Self {
        let result = subject.result;
        let odd = if result.as_expected {
            ""
        } else {
            ", not as expected"
        };
        Self {
            id: subject.id.clone(),
            letter: letter(result.verdict),
            class: class(result.verdict),
            surprising: !result.as_expected,
            title: format!("{}: {}{odd}", subject.name, result.verdict),
        }
    }
}

impl Matrix {
    pub(crate) fn new(site: &Site) -> Self {
        let used: Vec<usize> = (0..site.cases.len())
            .filter(|&i| site.members(&site.cases[i]).iter().any(|s| !s.is_control()))
            .collect();
        let columns = used.iter().map(|&i| column(site, i)).collect();
        let mut groups: BTreeMap<(usize, &str), BTreeMap<String, Vec<&Subject>>> = BTreeMap::new();
        for subject in site.subjects.iter().filter(|s| !s.is_control()) {
            let kind = subject.result.kind.as_str();
            let rows = groups.entry((rank(kind), kind)).or_default();
            rows.entry(row_name(subject)).or_default().push(subject);
        }
        let groups = groups.into_iter().map(|((_, name), rows)| Group {
            name: clean(&kind(name), 60),
            rows: rows
                .into_iter()
                .map(|(name, members)| row(name, &members, &used))
                .collect(),
        });
        Self {
            columns,
            groups: groups.collect(),
        }
    }
}

fn rank(kind: &str) -> usize {
    ["free_path", "transmittance", "chromatic"]
        .iter()
        .position(|k| *k == kind)
        .unwrap_or(3)
}

/// The estimator, with the rule of a stepping method, since each rule has its own order.
fn row_name(subject: &Subject) -> String {
    let rule = subject
        .result
        .order
        .as_ref()
        .map_or(String::new(), |o| format!(", {}", o.rule));
    clean(&words(&format!("{}{rule}", subject.result.estimator)), 40)
}

fn column(site: &Site, i: usize) -> Column {
    let case = &site.cases[i];
    let short = clean(&case.title, 30);
    Column {
        number: i + 1,
        id: case.id.clone(),
        short,
        title: case.title.clone(),
    }
}

fn row(name: String, members: &[&Subject], used: &[usize]) -> MatrixRow {
    let cell = |i: &usize| {
        members
            .iter()
            .filter(|s| s.case == *i)
            .map(|s| Letter::new(s))
            .collect()
    };
    MatrixRow {
        name,
        cells: used.iter().map(cell).collect(),
    }
}

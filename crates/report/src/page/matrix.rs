//! Estimators against media: a letter for each verdict.

use super::words::{class, letter};
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
        let odd = if result.as_expected { "" } else { ", not as expected" };
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
        let used = columns(site);
        let columns = used.iter().map(|cases| column(site, cases)).collect();
        let mut groups: BTreeMap<(usize, &str), BTreeMap<String, Vec<&Subject>>> = BTreeMap::new();
        for subject in site.subjects.iter().filter(|s| !s.is_control()) {
            let kind = subject.result.kind.as_str();
            let rows = groups.entry((site.rank_of_kind(kind), kind)).or_default();
            rows.entry(row_name(subject)).or_default().push(subject);
        }
        let groups = groups.into_iter().map(|((_, name), rows)| Group {
            name: clean(&site.heading_of_kind(name), 60),
            rows: rows.into_iter().map(|(name, members)| row(name, &members, &used)).collect(),
        });
        Self { columns, groups: groups.collect() }
    }
}

/// The estimator, with its rule if it has one, since each rule is a method of its own.
fn row_name(subject: &Subject) -> String {
    let result = subject.result;
    let rule = result.parameters.get(&result.kind).and_then(|of| of.get(&result.estimator)?.get("rule")?.as_str());
    let rule = rule.map_or(String::new(), |rule| format!(", {rule}"));
    clean(&words(&format!("{}{rule}", result.estimator)), 40)
}

/// The cases that hold more than controls: those of one file, its rays, share a column.
fn columns(site: &Site) -> Vec<Vec<usize>> {
    let shown = |i: &usize| site.members(&site.cases[*i]).iter().any(|s| !s.is_control());
    let mut columns: Vec<Vec<usize>> = Vec::new();
    for i in (0..site.cases.len()).filter(shown) {
        let same = |column: &&mut Vec<usize>| file(site, column[0]) == file(site, i);
        match columns.last_mut().filter(same) {
            Some(column) => column.push(i),
            None => columns.push(vec![i]),
        }
    }
    columns
}

fn file<'a>(site: &'a Site<'a>, case: usize) -> &'a str {
    site.members(&site.cases[case]).first().map_or("", |subject| &subject.result.file)
}

/// Headed by the file's name, which is short; the title is under the pointer.
fn column(site: &Site, cases: &[usize]) -> Column {
    let case = &site.cases[cases[0]];
    let path = std::path::Path::new(file(site, cases[0]));
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    Column { number: case.number, id: case.id.clone(), short: clean(&words(&stem), 30), title: case.title.clone() }
}

fn row(name: String, members: &[&Subject], used: &[Vec<usize>]) -> MatrixRow {
    let cell = |cases: &Vec<usize>| {
        let here = members.iter().filter(|s| cases.contains(&s.case));
        here.map(|s| Letter::new(s)).collect()
    };
    MatrixRow { name, cells: used.iter().map(cell).collect() }
}

//! The format of a row: its columns, in the order of files and programs, and how each is read.

use super::escapes::{EscapeRule, Escapes};
use super::events::EVENT_WORDS;
use freepath_draws::{Row, column};
use freepath_formats::{Head, Refusal, Selected, Word};
use std::borrow::Cow;

/// The columns of a row, in the order of files and programs.
#[derive(Clone, Debug, PartialEq)]
pub struct RowFormat {
    /// The columns.
    pub columns: Vec<ColumnFormat>,
    /// Their names, as a message puts them.
    pub names: String,
    /// A column that a table must not hold besides.
    pub excess: Option<Excess>,
}

/// One column of a row.
#[derive(Clone, Debug, PartialEq)]
pub struct ColumnFormat {
    /// Its name in a table.
    pub name: String,
    /// Its place in a table.
    pub place: Place,
    /// The meaning of its numbers.
    pub reading: Reading,
    /// The destination of its numbers.
    pub fills: Fills,
}

/// The place of a column in a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// It is the only one.
    Only,
    /// The place that the user states: by name, or by number from 0.
    Stated(String),
    /// By its own name; in a table without names, which then has the columns of the row and no other, in this order.
    Named,
}

/// The meaning of the numbers of a column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reading {
    /// As they are.
    Plain,
    /// As free paths.
    FreePath(EscapeRule),
    /// As events, which say what the free paths of their rows are.
    Event,
}

/// The destination of the numbers of a column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fills {
    /// The column of draws of this name.
    Column(Cow<'static, str>),
    /// None, once the events have said their say.
    Event,
}

/// A column whose presence tells that a table is of something else.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Excess {
    /// Its name.
    pub name: String,
    /// The cause of the refusal.
    pub cause: String,
}

impl Place {
    /// The place that the user states, or the only one.
    #[must_use]
    pub fn stated(column: Option<&str>) -> Self {
        column.map_or(Self::Only, |name| Self::Stated(name.to_string()))
    }
}

impl Reading {
    fn words(self) -> &'static [Word] {
        match self {
            Self::Plain | Self::FreePath(_) => &[],
            Self::Event => EVENT_WORDS,
        }
    }
}

impl RowFormat {
    fn of(columns: Vec<ColumnFormat>) -> Self {
        let names: Vec<_> = columns.iter().map(|column| column.name.as_str()).collect();
        let names = names.join(", ");
        Self { columns, names, excess: None }
    }

    /// A free path.
    #[must_use]
    pub fn free_path(column: Place, rule: EscapeRule) -> Self {
        Self::of(vec![column_of("t", column, Reading::FreePath(rule), of(column::T))])
    }

    /// A free path and its statistical weight.
    #[must_use]
    pub fn weighted_free_path(column: Place, weight: Place, rule: EscapeRule) -> Self {
        let t = column_of("t", column, Reading::FreePath(rule), of(column::T));
        Self::of(vec![t, column_of("weight", weight, Reading::Plain, of(column::channel(0)))])
    }

    /// A number, in the column that is called so here and in messages.
    #[must_use]
    pub fn number(name: &'static str, column: Place) -> Self {
        Self::of(vec![column_of(name, column, Reading::Plain, of(name))])
    }

    /// An estimate.
    #[must_use]
    pub fn estimate(column: Place) -> Self {
        Self::of(vec![column_of("weight", column, Reading::Plain, of(column::WEIGHT))])
    }

    /// A distance on a ray of this length, an event, and a weight for each channel.
    #[must_use]
    pub fn chromatic(length: f64, channels: usize) -> Self {
        let rule = EscapeRule { length, escapes: Escapes::AtInfinity };
        let t = column_of("t", Place::Named, Reading::FreePath(rule), of(column::T));
        let event = column_of("event", Place::Named, Reading::Event, Fills::Event);
        let weight = |k| column_of(&format!("w{k}"), Place::Named, Reading::Plain, of(column::channel(k)));
        let excess = Excess {
            name: format!("w{channels}"),
            cause: format!("it has more weights than the {channels} channels of the medium"),
        };
        Self {
            columns: [t, event].into_iter().chain((0..channels).map(weight)).collect(),
            names: format!("t, event, w0 to w{}", channels.saturating_sub(1)),
            excess: Some(excess),
        }
    }

    /// The count of numbers in a row where nothing else says it.
    #[must_use]
    pub(crate) fn across(&self) -> usize {
        let whole = self.columns.iter().all(|column| column.place == Place::Named);
        if whole { self.columns.len() } else { 1 }
    }

    /// Finds the columns in a table.
    ///
    /// # Errors
    /// If one is not there, or the table says that it is of something else.
    pub(crate) fn select(&self, head: &Head) -> Result<Vec<Selected>, Refusal> {
        let find = |(i, column): (usize, &ColumnFormat)| {
            let place = match &column.place {
                Place::Only => only(head)?,
                Place::Stated(name) => head.column(name)?,
                Place::Named => self.named(head, i)?,
            };
            Ok(Selected { column: place, words: column.reading.words() })
        };
        self.columns.iter().enumerate().map(find).collect()
    }

    /// The `i`-th column by its name, or else in this order.
    fn named(&self, head: &Head, i: usize) -> Result<usize, Refusal> {
        let refuse = |cause: String| Refusal::new(cause, &self.names);
        let (due, across) = (self.columns.len(), head.across());
        if head.names().is_empty() {
            let other = || refuse(format!("it has {across} columns, not {due}"));
            return (across == due).then_some(i).ok_or_else(other);
        }
        let more = self.excess.as_ref().filter(|excess| head.names().contains(&excess.name));
        if let Some(excess) = more {
            return Err(refuse(excess.cause.clone()));
        }
        let name = &self.columns[i].name;
        head.named(name)?.ok_or_else(|| refuse(format!("it has no column {name:?}")))
    }

    /// The columns of draws that are filled.
    #[must_use]
    pub fn row(&self) -> Row {
        self.columns.iter().fold(Row::new(), |row, column| match &column.fills {
            Fills::Column(name) => row.with_f64(name.clone()),
            Fills::Event => row,
        })
    }
}

/// The column of draws of this name.
fn of(name: impl Into<Cow<'static, str>>) -> Fills {
    Fills::Column(name.into())
}

fn column_of(name: &str, place: Place, reading: Reading, fills: Fills) -> ColumnFormat {
    ColumnFormat { name: name.to_string(), place, reading, fills }
}

fn only(head: &Head) -> Result<usize, Refusal> {
    match head.across() {
        1 => Ok(0),
        across => Err(Refusal::new(format!("it has {across} columns"), "one, or a stated `column`")),
    }
}

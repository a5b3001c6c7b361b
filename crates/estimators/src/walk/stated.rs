//! Matrices and vectors over states, as a scene states them.

use super::matrix::{Listed, Matrix};
use crate::parameter::{ParameterError, finite, require};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Most states.
pub(super) const MOST_STATES: usize = 1 << 20;

/// A square matrix over the states, which are numbered from 0.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum StatedMatrix {
    /// All of its rows.
    Rows(Vec<Vec<f64>>),
    /// The entries that are not 0.
    Entries(Entries),
    /// The same entries beside the diagonal in each row.
    Bands(Bands),
    /// The same entry everywhere.
    Alike(Alike),
}

/// The entries that are not 0.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Entries {
    /// The number of states.
    pub states: usize,
    /// Row, column and entry of each, in any order.
    pub entries: Vec<Entry>,
}

/// Row, column and entry.
pub type Entry = (usize, usize, f64);

/// The same entries beside the diagonal in each row; those that would lie outside are left out.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Bands {
    /// The number of states.
    pub states: usize,
    /// Column less row, and entry, of each band.
    pub bands: Vec<Band>,
}

/// Column less row, and entry.
pub type Band = (i64, f64);

/// The same entry everywhere.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Alike {
    /// The number of states.
    pub states: usize,
    /// The sum of each row.
    pub row_sum: f64,
}

impl StatedMatrix {
    /// The matrix.
    ///
    /// # Errors
    /// Of entries that are no numbers, outside, or there twice, of rows of another length, and of too many states.
    pub(super) fn matrix(&self, name: &'static str) -> Result<Matrix, ParameterError> {
        let states = self.states();
        require((1..=MOST_STATES).contains(&states), name, states, "a square matrix over 1 to 1048576 states")?;
        match self {
            Self::Alike(Alike { row_sum, .. }) => {
                Ok(Matrix::Alike { states, value: finite(name, *row_sum)? / states as f64 })
            }
            Self::Rows(rows) => listed(name, states, dense(name, rows)?),
            Self::Entries(Entries { entries, .. }) => listed(name, states, entries.clone()),
            Self::Bands(Bands { bands, .. }) => listed(name, states, banded(states, bands)),
        }
    }

    fn states(&self) -> usize {
        match self {
            Self::Rows(rows) => rows.len(),
            Self::Entries(Entries { states, .. })
            | Self::Bands(Bands { states, .. })
            | Self::Alike(Alike { states, .. }) => *states,
        }
    }
}

fn dense(name: &'static str, rows: &[Vec<f64>]) -> Result<Vec<Entry>, ParameterError> {
    let mut entries = Vec::new();
    for (i, row) in rows.iter().enumerate() {
        if row.len() != rows.len() {
            let why = format!(
                "row {i} has {} entries, and there are {} rows (a square matrix is needed)",
                row.len(),
                rows.len()
            );
            return Err(ParameterError::unusable(name, why));
        }
        entries
            .extend(row.iter().enumerate().filter(|(_, entry)| **entry != 0.0).map(|(j, entry)| (i, j, *entry)));
    }
    Ok(entries)
}

fn banded(states: usize, bands: &[Band]) -> Vec<Entry> {
    let inside =
        |i: usize, offset: i64| i64::try_from(i).ok()?.checked_add(offset).and_then(|j| usize::try_from(j).ok());
    let row = |i: usize| {
        let columns = bands.iter().filter_map(move |&(offset, entry)| inside(i, offset).map(|j| (i, j, entry)));
        columns.filter(move |&(_, j, _)| j < states)
    };
    (0..states).flat_map(row).collect()
}

fn listed(name: &'static str, states: usize, entries: Vec<Entry>) -> Result<Matrix, ParameterError> {
    let mut rows = vec![Vec::new(); states];
    for (i, j, entry) in entries {
        finite(name, entry)?;
        if i >= states || j >= states {
            let why = format!("there is no place ({i}, {j}) among {states} states (0 to {})", states - 1);
            return Err(ParameterError::unusable(name, why));
        }
        if entry != 0.0 {
            rows[i].push((j, entry));
        }
    }
    for (i, row) in rows.iter_mut().enumerate() {
        row.sort_by_key(|(j, _)| *j);
        if let Some(twice) = row.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            return Err(ParameterError::unusable(name, format!("the place ({i}, {}) is there twice", twice[0].0)));
        }
    }
    Ok(Matrix::Listed(Listed::of(&rows)))
}

/// A number for each state.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum StatedVector {
    /// One for each state.
    List(Vec<f64>),
    /// 1 in one state, 0 in all others.
    One(One),
    /// The same in every state.
    All(All),
}

/// 1 in one state, 0 in all others.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct One {
    /// The state.
    pub state: usize,
}

/// The same in every state.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct All {
    /// The number.
    pub all: f64,
}

impl StatedVector {
    /// The numbers.
    ///
    /// # Errors
    /// Of what are no numbers, or not as many as there are states, and of a state that is not there.
    pub(super) fn numbers(&self, name: &'static str, states: usize) -> Result<Vec<f64>, ParameterError> {
        match self {
            Self::All(All { all }) => Ok(vec![finite(name, *all)?; states]),
            Self::One(One { state }) => {
                let mut numbers = vec![0.0; states];
                let why =
                    || ParameterError::new(name, state, format!("one of {states} states (0 to {})", states - 1));
                *numbers.get_mut(*state).ok_or_else(why)? = 1.0;
                Ok(numbers)
            }
            Self::List(list) => {
                if list.len() != states {
                    let why = format!("it has {} numbers, and there are {states} states", list.len());
                    return Err(ParameterError::unusable(name, why));
                }
                list.iter().map(|&number| finite(name, number)).collect()
            }
        }
    }
}

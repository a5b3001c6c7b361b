//! Functions of x, and atoms, as a scene states them.

use crate::medium::PiecewiseConstant;
use crate::parameter::{ParameterError, require};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A function of x: a formula, or a table between whose rows it is linear.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Curve {
    /// A formula in x, such as `6*x*(1 - x)`.
    Formula(String),
    /// A table.
    Table(Table),
}

/// Values at places, linear between them.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Table {
    /// Places, increasing from one end of the domain to the other.
    pub x: Vec<f64>,
    /// The value at each place.
    pub y: Vec<f64>,
}

/// A number that is drawn with a probability of its own.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Atom {
    /// The number.
    pub at: f64,
    /// Its probability.
    pub mass: f64,
}

/// Refuses a table that does not go from one end of the domain to the other.
pub(super) fn ends(name: &'static str, x: &[f64], [a, b]: [f64; 2]) -> Result<(), ParameterError> {
    let same = |x: Option<&f64>, end: f64| x.is_some_and(|x| x.total_cmp(&end).is_eq());
    let holds = same(x.first(), a) && same(x.last(), b);
    require(holds, name, "other places", "a table from one end of the domain to the other").map(drop)
}

/// The density under a distribution function that is linear between the rows of a table.
pub(super) fn slopes(x: &[f64], y: &[f64]) -> Result<PiecewiseConstant, ParameterError> {
    require(x.len() == y.len(), "cdf", y.len(), "as many values as places")?;
    let start = y.first().copied().unwrap_or(f64::NAN);
    require(start == 0.0, "cdf", start, "0 at the start of the domain")?;
    let edges = x.iter().map(|at| at - x[0]).collect();
    let slope = |(x, y): (&[f64], &[f64])| (y[1] - y[0]) / (x[1] - x[0]);
    let values = x.windows(2).zip(y.windows(2)).map(slope).collect();
    PiecewiseConstant::new(edges, values).map_err(|why| ParameterError::unusable("cdf", why))
}

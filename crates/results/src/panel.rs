use crate::Real;
use serde::{Deserialize, Serialize};

/// Quantities of numbered places, such as the states of a chain, drawn beside one another.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
pub struct PanelSeries {
    /// Its heading.
    pub title: String,
    /// What is to be seen, in words.
    pub words: String,
    /// What is numbered, from 0.
    pub places: String,
    /// The quantity, and its unit.
    pub quantity: String,
    /// The quantities by formula, each a number for each place; infinite where there is none.
    pub formulas: Vec<FormulaSeries>,
    /// What was measured at some place.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub measured: Option<Measured>,
    /// The places to be shaded.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub shaded: Vec<usize>,
    /// What shades mean.
    #[serde(skip_serializing_if = "String::is_empty", default)]
    pub shade: String,
}

/// A quantity by formula at each place.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
pub struct FormulaSeries {
    /// Its name.
    pub name: String,
    /// By place.
    pub values: Vec<Real>,
}

/// A number that draws gave at one place.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, Serialize)]
pub struct Measured {
    /// The place.
    pub place: usize,
    /// The number.
    pub value: Real,
    /// The end of its interval; the number itself where there is none.
    pub low: Real,
    /// As `low`.
    pub high: Real,
}

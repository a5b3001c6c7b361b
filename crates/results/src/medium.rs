use crate::Real;
use serde::{Deserialize, Serialize};

/// One medium along one ray.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct MediumResult {
    /// The case file.
    pub file: String,
    /// The title of the case.
    pub case: String,
    /// The ray of the case, if it has several.
    pub ray: Option<usize>,
    /// Its name in `freepath list`, such as `gaussian`.
    pub medium: String,
    /// As in the case.
    pub parameters: serde_json::Value,
    /// Length of the ray.
    pub length: Real,
    /// Optical depth of the ray; one for each channel.
    pub tau: Vec<Real>,
    /// Least and greatest mu.
    pub extrema: [Real; 2],
    /// The series that the plot draws; one for each channel.
    pub series: Vec<MediumSeries>,
}

/// mu, its majorant, tau and T along the ray.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
pub struct MediumSeries {
    /// The distances along the ray.
    pub t: Vec<Real>,
    /// Extinction.
    pub mu: Vec<Real>,
    /// Its bound.
    pub majorant: Vec<Real>,
    /// Optical depth; none in results of before it was kept.
    #[serde(default)]
    pub tau: Vec<Real>,
    /// exp(-tau(t)).
    pub transmittance: Vec<Real>,
}

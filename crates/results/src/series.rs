use crate::{CdfSeries, HistogramSeries, LifeTable, PanelSeries, ResidualSeries, RunningSeries};
use serde::{Deserialize, Serialize};

/// Most points in a series.
pub const MOST_POINTS: usize = 512;

/// The series that plots draw, at most [`MOST_POINTS`] points each.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
pub struct Series {
    /// Empirical minus analytic CDF.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub cdf: Option<CdfSeries>,
    /// Histogram over the analytic density.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub histogram: Option<HistogramSeries>,
    /// Chi-square residuals.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub residuals: Option<ResidualSeries>,
    /// The table of places along the ray where the law breaks.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub life_table: Option<LifeTable>,
    /// Running mean.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub running: Option<RunningSeries>,
    /// Quantities of numbered places.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub panels: Vec<PanelSeries>,
}

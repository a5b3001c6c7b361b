use super::{Categories, DiscreteSampler, Drawn, from_cumulative};
use crate::capability::Capability;
use freepath_draws::random::uniform;

/// Inversion of the distribution function by linear search, from the first category on.
///
/// ```text
/// i = min { j : u < c_j },   c_j = p_0 + .. + p_j
/// ```
///
/// Target: the table of probabilities; a category of weight 0 has an empty piece, and is never drawn, u = 0 included.
/// Range:  the categories.
/// Cost:   one uniform, sum (j + 1) p_j entries of the table on average: few if the likely ones stand first.
/// Needs:  the cumulative table.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LinearSearch {}

impl DiscreteSampler for LinearSearch {
    fn sample(&self, categories: &Categories, rng: &mut dyn rand::Rng) -> Drawn {
        let (u, cumulative) = (uniform(rng), &categories.tables().cumulative);
        // the last sum is 1, which every uniform is below
        let index = cumulative.iter().position(|sum| u < *sum).unwrap_or(cumulative.len() - 1);
        categories.drawn(from_cumulative(cumulative, index, u))
    }
    fn masses(&self, categories: &Categories) -> Option<Vec<f64>> {
        Some(categories.tables().steps())
    }
    fn capabilities(&self) -> Vec<Capability> {
        vec![Capability::CumulativeTable]
    }
}

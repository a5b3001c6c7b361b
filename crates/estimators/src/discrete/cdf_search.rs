use super::{Categories, DiscreteSampler, Drawn, from_cumulative};
use crate::capability::Capability;
use freepath_draws::random::uniform;

/// Inversion of the distribution function by binary search: the first category whose cumulative probability exceeds the uniform.
///
/// ```text
/// i = min { j : u < c_j },   c_j = p_0 + .. + p_j
/// ```
///
/// Target: the table of probabilities; a category of weight 0 has an empty piece, and is never drawn, u = 0 included.
/// Range:  the categories.
/// Cost:   one uniform, at most log2(n) + 1 entries of the table; n of memory.
/// Needs:  the cumulative table.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CdfSearch {}

impl DiscreteSampler for CdfSearch {
    fn sample(&self, categories: &Categories, rng: &mut dyn rand::Rng) -> Drawn {
        let (u, cumulative) = (uniform(rng), &categories.tables().cumulative);
        let index = cumulative.partition_point(|sum| *sum <= u);
        categories.drawn(from_cumulative(cumulative, index, u))
    }
    fn masses(&self, categories: &Categories) -> Option<Vec<f64>> {
        Some(categories.tables().steps())
    }
    fn capabilities(&self) -> Vec<Capability> {
        vec![Capability::CumulativeTable]
    }
}

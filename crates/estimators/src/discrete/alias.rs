use super::{Categories, DiscreteSampler, Drawn};
use crate::capability::Capability;
use freepath_draws::random::uniform;

/// The alias method (Walker 1977), with the table of Vose (1991): one cell of n, shared by two categories at the most.
///
/// ```text
/// cell = floor(n u),   its own category if frac(n u) < keep, its alias if not
/// ```
///
/// Target: the table of probabilities; a category of weight 0 keeps nothing of its cell, and is nobody's alias.
/// Range:  the categories.
/// Cost:   one uniform, two entries of the table, however many categories there are; 2 n of memory.
/// Needs:  the alias table. Neighbouring uniforms give distant categories, which stratified points do not like.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Alias {}

impl DiscreteSampler for Alias {
    fn sample(&self, categories: &Categories, rng: &mut dyn rand::Rng) -> Drawn {
        categories.drawn(categories.tables().alias.pick(uniform(rng)))
    }
    fn masses(&self, categories: &Categories) -> Option<Vec<f64>> {
        Some(categories.tables().alias.masses())
    }
    fn capabilities(&self) -> Vec<Capability> {
        vec![Capability::AliasTable]
    }
}

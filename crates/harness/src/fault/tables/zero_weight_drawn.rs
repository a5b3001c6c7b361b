use crate::fault::Injection;
use freepath_estimators::Capability;
use freepath_estimators::discrete::Tables;

/// A uniform of just a cumulative probability belongs to the category before it (Distributions.jl, issue 1105).
///
/// ```text
/// right: the first i with u < c_i;   wrong: the first i with u <= c_i
/// ```
///
/// Shows in: u = 0, which draws a first category of weight 0: once in 2^53 draws, and at once under scripted uniforms.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ZeroWeightDrawn {}

impl Injection for ZeroWeightDrawn {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::CumulativeTable]
    }
    fn alter_tables(&self, _: &[f64], mut tables: Tables) -> Tables {
        // u <= c is u < the next number above c
        tables.cumulative.iter_mut().for_each(|sum| *sum = sum.next_up());
        tables
    }
}

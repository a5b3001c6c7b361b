use crate::fault::Injection;
use freepath_estimators::Capability;
use freepath_estimators::discrete::{AliasTable, Tables};

/// The alias table is made of the weights as they are, as if they summed up to 1 (Distributions.jl, issue 832).
///
/// ```text
/// right: n w_i / sum w against 1;   wrong: n w_i against 1
/// ```
///
/// Shows in: weights of 1 and more, none of which is below a share of 1/n, are drawn alike; weights that sum up to 1 come right.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UnnormalisedAlias {}

impl Injection for UnnormalisedAlias {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::AliasTable]
    }
    fn alter_tables(&self, weights: &[f64], tables: Tables) -> Tables {
        Tables { alias: AliasTable::new(weights, 1.0), ..tables }
    }
}

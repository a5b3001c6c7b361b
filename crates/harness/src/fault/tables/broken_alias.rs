use crate::fault::Injection;
use freepath_estimators::Capability;
use freepath_estimators::discrete::{AliasTable, Tables};

/// Pairing ends at the first tie, a category that is left with just its own share (EGSnrc, issue 557: a strict comparison).
///
/// ```text
/// right: pairs until no category is left below 1/n;   wrong: until one that has given is left with 1/n
/// ```
///
/// Shows in: weights 10 : 10 : 1 : 1 come as 10 : 5.5 : 1 : 5.5; weights without ties come right.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BrokenAlias {}

impl Injection for BrokenAlias {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::AliasTable]
    }
    fn alter_tables(&self, weights: &[f64], tables: Tables) -> Tables {
        let total = weights.iter().sum();
        Tables { alias: AliasTable::paired_while(weights, total, |left| left.total_cmp(&total).is_ne()), ..tables }
    }
}

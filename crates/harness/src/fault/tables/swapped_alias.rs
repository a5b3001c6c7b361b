use crate::fault::Injection;
use freepath_estimators::Capability;
use freepath_estimators::discrete::Tables;

/// The alias of a cell is taken for its own category, and the other way round (Hypothesis, issue 1049).
///
/// ```text
/// right: its own category if frac(n u) < keep;   wrong: its alias
/// ```
///
/// Shows in: every cell that is shared unevenly; nothing where equal weights need no alias.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SwappedAlias {}

impl Injection for SwappedAlias {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::AliasTable]
    }
    fn alter_tables(&self, _: &[f64], mut tables: Tables) -> Tables {
        tables.alias.keep.iter_mut().for_each(|keep| *keep = 1.0 - *keep);
        tables
    }
}

use crate::fault::Injection;
use freepath_estimators::Capability;
use freepath_estimators::discrete::Tables;

/// Aliases are off by one: numbered from 1 where they are read, from 0 where they are made (PyTorch, issue 21324).
///
/// ```text
/// right: the alias of a cell;   wrong: the category behind it, behind the last one the first
/// ```
///
/// Shows in: all that is drawn as an alias; nothing where equal weights need none.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShiftedAlias {}

impl Injection for ShiftedAlias {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::AliasTable]
    }
    fn alter_tables(&self, _: &[f64], mut tables: Tables) -> Tables {
        let n = tables.alias.alias.len();
        tables.alias.alias.iter_mut().for_each(|alias| *alias = (*alias + 1) % n);
        tables
    }
}

use crate::fault::Injection;
use freepath_estimators::Capability;
use freepath_estimators::walk::System;

/// Walks go along the transposed matrix, and start and score as along the matrix itself (a typical slip).
///
/// ```text
/// right: <h, (1 - H)^-1 b>;   wrong: <h, (1 - H^T)^-1 b>
/// ```
///
/// Shows in: the mean; nowhere where the matrix is symmetric, nor where source and detector are the same.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RowForColumn {}

impl Injection for RowForColumn {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::WalkTables]
    }
    fn alter_walks(&self, system: System) -> Result<System, String> {
        system.with_steps_exchanged()
    }
}

use crate::fault::Injection;
use freepath_estimators::Capability;
use freepath_estimators::table_2d::{Grid, GridTables};

/// The cell is drawn from the conditional law of the next row (a typical slip).
///
/// ```text
/// right: j from c_ij;   wrong: j from c_(i+1)j, of the last row from the first
/// ```
///
/// Shows in: the law of x given y, in cells without mass; nowhere where all rows are proportional.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ConditionalOfNeighbourRow {}

impl Injection for ConditionalOfNeighbourRow {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::ConditionalTable]
    }
    fn alter_grid(&self, grid: &Grid, mut tables: GridTables) -> GridTables {
        tables.cells.rotate_left(grid.columns());
        tables
    }
}

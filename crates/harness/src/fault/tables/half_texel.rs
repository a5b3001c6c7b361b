use crate::fault::Injection;
use freepath_estimators::Capability;
use freepath_estimators::table_2d::{Grid, GridTables};

/// Cells lie half a cell further on, as if a value stood at the place of its index (pbrt-v3, issue 62).
///
/// ```text
/// right: cell j from a + j h to a + (j + 1) h;   wrong: from a + (j + 1/2) h
/// ```
///
/// Shows in: the law along both sides, and in places beyond the far ends of the rectangle.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HalfTexel {}

impl Injection for HalfTexel {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::ConditionalTable]
    }
    fn alter_grid(&self, grid: &Grid, tables: GridTables) -> GridTables {
        let moved = |[from, to]: [f64; 2], cells: usize| {
            let half = 0.5 * (to - from) / cells as f64;
            [from + half, to + half]
        };
        GridTables { x: moved(tables.x, grid.columns()), y: moved(tables.y, grid.rows()), ..tables }
    }
}

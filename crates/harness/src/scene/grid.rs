use super::{Scene, StatedScene};
use freepath_estimators::ParameterError;
use freepath_estimators::table_2d::Grid as Truth;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A density on a rectangle that is constant in each cell of a table.
///
/// ```text
/// p(x, y) = f_ij / (A sum f / n),   n cells on an area A, row i across y, column j along x
/// ```
///
/// A cell of value 0 is never drawn.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(example = serde_json::json!({ "values": [[1, 0, 3, 2], [0, 0, 0, 0], [4, 1, 0, 5]] }))]
pub struct Grid {
    /// Rows of values of any sum, the first one at the start of y: as many in each, up to 1,048,576 in all.
    pub values: Vec<Vec<f64>>,
    /// The ends of x, and those of y.
    #[serde(default = "unit_square")]
    pub domain: [[f64; 2]; 2],
}

fn unit_square() -> [[f64; 2]; 2] {
    [[0.0, 1.0], [0.0, 1.0]]
}

impl Grid {
    /// The grid.
    ///
    /// # Errors
    /// Naming the parameter that makes none.
    pub(crate) fn truth(&self) -> Result<Truth, ParameterError> {
        Truth::new(&self.values, self.domain)
    }
}

impl Scene for Grid {}

impl StatedScene for Grid {
    fn check(&self) -> Result<(), ParameterError> {
        self.truth().map(drop)
    }
}

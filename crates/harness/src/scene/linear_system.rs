use super::{Scene, StatedScene};
use freepath_estimators::ParameterError;
use freepath_estimators::walk::{Stated, StatedMatrix, StatedVector, Steps, System};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A linear system, and the number that is asked of its solution.
///
/// ```text
/// x = H x + b,   <h, x> = sum_i h_i x_i
/// ```
///
/// Coefficients may be negative. The spectral radius of |H| is below 1, or no walk has a mean; where that of H_ij^2 / P_ij is not, a walk has
/// no variance.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(example = serde_json::json!({ "coefficients": [[0, 0.9], [0.9, 0]], "source": { "all": 1 }, "detector": { "state": 0 } }))]
pub struct LinearSystem {
    /// H: rows, `{"states": n, "entries": [[row, column, entry], ..]}`, `{"states": n, "bands": [[column - row, entry], ..]}`, or
    /// `{"states": n, "row_sum": s}` for s/n everywhere.
    pub coefficients: StatedMatrix,
    /// b: one number for each state, `{"state": i}`, or `{"all": b}`.
    pub source: StatedVector,
    /// h: `{"state": i}` for x_i alone, one number for each state, or `{"all": h}`.
    pub detector: StatedVector,
    /// The probabilities of the steps of a walk along H: a matrix, or their sum for steps as the sizes of the coefficients (default: |H|).
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub steps: Option<Steps>,
    /// The same of a walk along the transposed H.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub adjoint_steps: Option<Steps>,
}

impl LinearSystem {
    /// The system.
    ///
    /// # Errors
    /// Naming the parameter that makes none.
    pub fn system(&self) -> Result<System, ParameterError> {
        System::new(Stated {
            names: ["coefficients", "source", "detector"],
            coefficients: &self.coefficients,
            source: &self.source,
            detector: &self.detector,
            steps: self.steps.as_ref(),
            adjoint_steps: self.adjoint_steps.as_ref(),
        })
    }
}

impl Scene for LinearSystem {}

impl StatedScene for LinearSystem {
    fn check(&self) -> Result<(), ParameterError> {
        self.system().map(drop)
    }
}

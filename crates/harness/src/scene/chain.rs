use super::{Scene, StatedScene};
use freepath_estimators::ParameterError;
use freepath_estimators::parameter::not_negative;
use freepath_estimators::walk::{Listed, Matrix, One, Stated, StatedMatrix, StatedVector, Steps, System};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// An absorbing Markov chain, and a state whose visits are counted.
///
/// ```text
/// x_j = sum_i p0_i [(1 - P)^-1]_ij,   an end in i with p*_i = 1 - sum_j P_ij
/// ```
///
/// x_j is the expected number of visits to j, the first and the last state of a walk included.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(example = serde_json::json!({ "start": [0.5, 0.5], "transition": [[0.1, 0.4], [0.2, 0.3]], "state": 1 }))]
pub struct Chain {
    /// p0: the probability to start in each state, or `{"state": i}`.
    pub start: StatedVector,
    /// P: rows, `{"states": n, "entries": [[from, to, probability], ..]}`, `{"states": n, "bands": [[to - from, probability], ..]}`, or
    /// `{"states": n, "row_sum": s}` for s/n everywhere.
    pub transition: StatedMatrix,
    /// j.
    pub state: usize,
    /// The probabilities of the steps of a walk back along the transposed P: a matrix, or their sum (default: P itself).
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub adjoint_steps: Option<Steps>,
}

/// The most by which the probabilities of the starts may miss 1.
const ROUNDING: f64 = 1e-12;

impl Chain {
    /// The system.
    ///
    /// # Errors
    /// Naming the parameter that makes none.
    pub fn system(&self) -> Result<System, ParameterError> {
        let system = System::new(Stated {
            names: ["transition", "state", "start"],
            coefficients: &self.transition,
            source: &StatedVector::One(One { state: self.state }),
            detector: &self.start,
            steps: None,
            adjoint_steps: self.adjoint_steps.as_ref(),
        })?;
        let starts = system.detector();
        starts.iter().try_for_each(|&start| not_negative("start", start).map(drop))?;
        let total: f64 = starts.iter().sum();
        if !((total - 1.0).abs() <= ROUNDING) {
            return Err(ParameterError::unusable(
                "start",
                format!("the probabilities sum up to {total} (1 is needed)"),
            ));
        }
        match system.coefficients() {
            Matrix::Alike { value, .. } => not_negative("transition", *value).map(drop)?,
            Matrix::Listed(listed) => refuse_negative(listed)?,
        }
        Ok(system)
    }
}

fn refuse_negative(listed: &Listed) -> Result<(), ParameterError> {
    for (i, row) in listed.rows().iter().enumerate() {
        if let Some((j, probability)) = row.iter().find(|(_, probability)| !(*probability >= 0.0)) {
            let why = format!("the probability from {i} to {j} is {probability} (0 or above)");
            return Err(ParameterError::unusable("transition", why));
        }
    }
    Ok(())
}

impl Scene for Chain {}

impl StatedScene for Chain {
    fn check(&self) -> Result<(), ParameterError> {
        self.system().map(drop)
    }
}

use super::{Scene, StatedScene};
use freepath_estimators::ParameterError;
use freepath_estimators::parameter::require;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A number that is simply stated: the truth of anybody's estimator, and what is known of one estimate.
///
/// ```text
/// E[X] = value,   low <= X <= high,   Var[X] = variance
/// ```
///
/// Without range and variance no test of a mean is valid for all laws (Bahadur and Savage 1956): then gates on skewness and tail
/// decide whether one can be made.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(example = serde_json::json!({ "value": 0.5, "range": [0, 1] }))]
pub struct Number {
    /// The mean of an estimate.
    pub value: f64,
    /// The least and greatest estimate.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub range: Option<[f64; 2]>,
    /// The variance of an estimate.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    #[schemars(range(min = 0))]
    pub variance: Option<f64>,
}

impl Scene for Number {}

impl StatedScene for Number {
    fn check(&self) -> Result<(), ParameterError> {
        require(self.value.is_finite(), "value", self.value, "a finite number")?;
        if let Some([low, high]) = self.range {
            let holds = low < high && low.is_finite() && high.is_finite();
            require(holds, "range", low, "two finite numbers, the least first")?;
            require(low <= self.value && self.value <= high, "value", self.value, "inside the range")?;
        }
        let variance = self.variance.unwrap_or(0.0);
        require(variance >= 0.0 && variance.is_finite(), "variance", variance, "finite and not negative").map(drop)
    }
}

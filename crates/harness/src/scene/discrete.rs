use super::{Scene, StatedScene};
use freepath_estimators::ParameterError;
use freepath_estimators::discrete::{Categories, Weights};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A finite table of probabilities: weights over their sum.
///
/// ```text
/// p_i = w_i / sum w
/// ```
///
/// Categories are numbered from 0. One of weight 0 is never drawn.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(example = serde_json::json!({ "weights": [10, 10, 1, 1] }))]
pub struct Discrete {
    /// The weights, of any sum: a list, or a formula in the category i, such as `1/(i + 1)`.
    pub weights: Weights,
    /// The number of categories of a formula, up to 1,048,576.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub count: Option<usize>,
}

impl Discrete {
    /// The categories.
    ///
    /// # Errors
    /// Naming the parameter that makes none.
    pub(crate) fn categories(&self) -> Result<Categories, ParameterError> {
        Categories::new(&self.weights, self.count)
    }
}

impl Scene for Discrete {}

impl StatedScene for Discrete {
    fn check(&self) -> Result<(), ParameterError> {
        self.categories().map(drop)
    }
}

use super::{Scene, StatedScene};
use freepath_estimators::ParameterError;
use freepath_estimators::direction::{DirectionLaw, Directions as Truth};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A law of directions about a normal: a density per solid angle.
///
/// ```text
/// int over the sphere of p(w) dw = 1
/// ```
///
/// A sampler sees the normal alone. What is right about z may be wrong about -z, where a local frame breaks: have a case for each of
/// a few normals.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(example = serde_json::json!({ "law": { "cosine_hemisphere": {} }, "normal": [0, 0, 1] }))]
pub struct Directions {
    /// The density.
    pub law: DirectionLaw,
    /// The normal, a unit vector in double precision.
    pub normal: [f64; 3],
}

impl Directions {
    /// The law.
    ///
    /// # Errors
    /// Naming the parameter that makes none.
    pub fn truth(&self) -> Result<Truth, ParameterError> {
        Truth::new(self.law, self.normal)
    }
}

impl Scene for Directions {}

impl StatedScene for Directions {
    fn check(&self) -> Result<(), ParameterError> {
        self.truth().map(drop)
    }
}

/// Inversion of the law of y and of that of x given y, from the truth: the positive control.
///
/// Target: the law of the scene.
/// Range:  the rectangle.
/// Cost:   two uniforms.
/// Needs:  the truth, which only the harness knows.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Exact {}

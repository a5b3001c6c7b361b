/// Inversion of both distribution functions, of the angle to the normal and of the azimuth, from the truth: the positive control.
///
/// Target: the law of the scene.
/// Range:  its support.
/// Cost:   two uniforms.
/// Needs:  the truth, which only the harness knows.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Exact {}

/// The integral itself, without noise: the positive control.
///
/// Target: the integral of the scene.
/// Range:  the integral alone.
/// Cost:   nothing.
/// Needs:  the truth, which only the harness knows.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Value {}

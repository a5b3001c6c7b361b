/// The number itself, without noise: the positive control of the tests.
///
/// Target: the number.
/// Range:  the number alone.
/// Cost:   nothing.
/// Needs:  the truth, which only the harness knows.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Value {}

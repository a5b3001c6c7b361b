/// Inversion of the distribution function, from the truth: the positive control.
///
/// Target: the law of the scene.
/// Range:  its domain.
/// Cost:   one uniform, some 6 evaluations of F; 60 where no density is known.
/// Needs:  the truth, which only the harness knows.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Exact {}

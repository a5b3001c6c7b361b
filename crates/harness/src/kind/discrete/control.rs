/// Inversion of the probabilities summed from the last category on, which no sampler reads: the positive control.
///
/// Target: the table of the scene.
/// Range:  the categories that have a weight.
/// Cost:   one uniform, log2(n) + 1 sums.
/// Needs:  the truth, which only the harness knows.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Exact {}

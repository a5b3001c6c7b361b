/// Inversion of the optical depth, from the truth: the positive control of the tests.
///
/// ```text
/// t = tau^-1(-ln(1 - u)), infinity beyond the end
/// ```
///
/// Target: the free-path law.
/// Range:  (0, length), or infinity for an escape; weight 1.
/// Cost:   no look-up.
/// Needs:  the optical depth, which only the harness knows.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Exact {}

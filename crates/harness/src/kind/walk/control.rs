/// The system solved by elimination, without noise: the positive control of the tests.
///
/// Target: <h, x>, x = H x + b.
/// Range:  <h, x> alone.
/// Cost:   n^3 / 3 products where every coefficient counts, n where they stand beside the diagonal; no walk.
/// Needs:  all of the system, which a walk sees one row at a time.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Direct {}

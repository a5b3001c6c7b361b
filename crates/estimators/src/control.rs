/// The control extinction of each majorant's segment.
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Control {
    /// The mean of mu in the segment.
    Mean,
    /// The minimum of mu in the segment.
    Minimum,
    /// This value everywhere.
    Value(f64),
}

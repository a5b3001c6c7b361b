/// A ray through a voxel grid.
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Ray {
    /// Its start, in world coordinates.
    pub origin: [f64; 3],
    /// Its direction; of any length.
    pub direction: [f64; 3],
}

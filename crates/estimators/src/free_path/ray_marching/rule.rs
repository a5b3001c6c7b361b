/// The place in its step where the extinction is looked up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(rename = "ray_marching_free_path_rule")]
pub enum MarchingRule {
    /// At its start.
    Left,
    /// In its middle.
    Midpoint,
    /// At the same random fraction of every step of a ray.
    Jitter,
    /// In its middle, where the collision is put, too.
    Snap,
}

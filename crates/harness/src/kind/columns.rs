//! The names of columns that several kinds have.

/// Distance along the ray, infinity for an escape.
pub(super) const T: &str = "t";
/// Statistical weight, or the estimate.
pub(super) const WEIGHT: &str = "weight";
/// Tentative collisions.
pub(super) const COLLISIONS: &str = "collisions";
/// A number in [0, 1) that goes with the draw.
pub(super) const MARK: &str = "mark";

/// The weight of a channel.
pub(super) fn channel(k: usize) -> String {
    format!("channel_{k}")
}

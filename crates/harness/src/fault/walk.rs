//! Faults laid over one walk at a time: the subject is driven by its scalar method.

use super::Layer;

pub(super) mod face_offset;
pub(super) mod killing_ratio;
pub(super) mod leftover_depth;
pub(super) mod local_step;
pub(super) mod restarted_walk;
pub(super) mod rounded_null;
pub(super) mod signed_roulette;
pub(super) mod split_products;
pub(super) mod stale_position;

/// The layer of every fault in this folder.
pub(super) const LAYER: Layer = Layer::Walk;

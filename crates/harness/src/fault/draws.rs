//! Faults laid over the draws of a block, or over its place in the stream: the subject is driven by its block method.

use super::Layer;

pub(super) mod absorbed_twice;
pub(super) mod bin_centre;
pub(super) mod cold_start;
pub(super) mod compensated_roulette;
pub(super) mod completion_order;
pub(super) mod copied_batch;
pub(super) mod duplicated_draws;
pub(super) mod hot_spot;
pub(super) mod leaked_record;
pub(super) mod nan_draw;
pub(super) mod same_seed;
pub(super) mod truncated_weight;
pub(super) mod uncompensated_roulette;
pub(super) mod window_weight;

/// The layer of every fault in this folder.
pub(super) const LAYER: Layer = Layer::Draws;

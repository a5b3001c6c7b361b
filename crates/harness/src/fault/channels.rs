//! Faults laid over the weights of a block of chromatic draws: the subject is driven by its block method.

use super::Layer;

pub(super) mod channel_pdf;
pub(super) mod dropped_channel;
pub(super) mod exchanged_weights;
pub(super) mod hero_nulls;
pub(super) mod sampled_depth;
pub(super) mod skewed_pdf;

/// The layer of every fault in this folder.
pub(super) const LAYER: Layer = Layer::Channels;

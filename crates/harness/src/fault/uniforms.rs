//! Faults laid over the uniforms of one walk at a time: the subject is driven by its scalar method.

use super::Layer;

pub(super) mod closed_end;
pub(super) mod even_uniforms;
pub(super) mod mirrored_batch;
pub(super) mod mirrored_uniforms;
pub(super) mod repeated_flight;
pub(super) mod reused_start;
pub(super) mod shared_uniform;
pub(super) mod wrong_wedge;
pub(super) mod zero_step;

/// The layer of every fault in this folder.
pub(super) const LAYER: Layer = Layer::Uniforms;

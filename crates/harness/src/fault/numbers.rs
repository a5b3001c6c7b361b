//! Faults laid over the uniforms of one draw at a time, of any sampler without a ray: the subject is driven by its scalar method.

use super::Layer;

pub(super) mod low_envelope;
pub(super) mod reused_uniform;

/// The layer of every fault in this folder.
pub(super) const LAYER: Layer = Layer::Numbers;

#[cfg(test)]
mod tests;

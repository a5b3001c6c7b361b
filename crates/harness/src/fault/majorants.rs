//! Faults laid over the majorants, under the audit: the subject is driven by its block method.

use super::Layer;

pub(super) mod cell_majorant;
pub(super) mod coarse_majorant;
pub(super) mod loose_majorant;
pub(super) mod short_majorant;

/// The layer of every fault in this folder.
pub(super) const LAYER: Layer = Layer::Majorants;

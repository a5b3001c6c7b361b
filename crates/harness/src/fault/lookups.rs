//! Faults laid over the look-ups and the ray, above the audit: the subject is driven by its block method.

use super::Layer;

pub(super) mod absolute_residual;
pub(super) mod alternating_extinction;
pub(super) mod backward_cells;
pub(super) mod clamped_density;
pub(super) mod density_cutoff;
pub(super) mod density_floor;
pub(super) mod direction_length;
pub(super) mod enhanced_cross_section;
pub(super) mod flipped_residual;
pub(super) mod inverted_acceptance;
pub(super) mod missing_scale;
pub(super) mod next_cell;
pub(super) mod shifted_lookup;
pub(super) mod shortened_segment;
pub(super) mod uncut_segment;

/// The layer of every fault in this folder.
pub(super) const LAYER: Layer = Layer::LookUps;

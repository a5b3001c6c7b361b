//! Faults laid over the tables that a program makes of its weights, or of its system: the subject is driven by its block method.

use super::Layer;

pub(super) mod broken_alias;
pub(super) mod conditional_of_neighbour_row;
pub(super) mod forgotten_absorption;
pub(super) mod half_texel;
pub(super) mod row_for_column;
pub(super) mod shifted_alias;
pub(super) mod stale_state;
pub(super) mod swapped_alias;
pub(super) mod uncounted_end;
pub(super) mod uncounted_start;
pub(super) mod unnormalised_alias;
pub(super) mod unnormalised_rows;
pub(super) mod zero_weight_drawn;

/// The layer of every fault in this folder.
pub(super) const LAYER: Layer = Layer::Tables;

#[cfg(test)]
mod tests;

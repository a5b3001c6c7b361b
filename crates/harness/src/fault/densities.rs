//! Faults laid over the division of an integrand by the density of its draws: the subject is driven by its block method.

use super::Layer;

pub(super) mod closed_interval;
pub(super) mod component_pdf;
pub(super) mod density_of_the_unwarped_variable;
pub(super) mod forgotten_pdf;
pub(super) mod unnormalised_mixture;

/// The layer of every fault in this folder.
pub(super) const LAYER: Layer = Layer::Densities;

#[cfg(test)]
mod tests;

//! Every medium and wrapper against quadrature, scans and the laws that tie them together.

mod depth;
mod descriptions;
mod laws;
mod look_ups;
mod majorants;
mod places;
mod wrappers;
mod zoo;

//! Free-path samplers, transmittance estimators and the media they are tried on: what is under test.
//!
//! No input or output, no statistics, no case files. An estimator sees an [`Extinction`] and its random numbers; only the
//! harness sees the [`Medium`], which knows the optical depth.

pub mod chromatic;
pub mod claims;
pub mod comb;
pub mod draws;
pub mod extinction;
pub mod free_path;
mod list;
pub mod majorants;
pub mod math;
pub mod medium;
pub mod parameter;
pub mod quadrature;
pub mod random;
pub mod simd;
pub mod transmittance;
pub mod woodcock;

pub use chromatic::ChromaticSampler;
pub use draws::Draws;
pub use extinction::{Cells, Extinction, Medium, Under};
pub use free_path::{FreePath, FreePathSampler};
pub use majorants::{MajorantChoice, Majorants};
pub use parameter::ParameterError;
pub use random::{Key, Streams};
pub use transmittance::TransmittanceEstimator;

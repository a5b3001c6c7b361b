//! Free-path samplers, transmittance estimators and the media they are tried on: what is under test.
//!
//! No input or output, no statistics, no case files. An estimator sees an [`Extinction`] and its random numbers; only the
//! harness sees the [`Medium`], which knows the optical depth.
//!
//! ```
//! use freepath_estimators::free_path::DeltaTracking;
//! use freepath_estimators::medium::Gaussian;
//! use freepath_estimators::{Extinction, FreePathSampler, Key, Medium};
//!
//! // A bump of height 4 at 0.9, of width 0.25, on a ray of length 2, over no base.
//! let medium = Gaussian::new(4.0, 0.9, 0.25, 2.0, 0.0)?;
//! let key = Key { seed: 1, subject: 0, block: 0 };
//! let path = DeltaTracking::default().sample(&medium, &mut key.rng());
//! assert!(path.t == f64::INFINITY || path.t < medium.length());
//!
//! // The escape probability, which no sampler may see.
//! let transmittance = (-medium.tau(medium.length())).exp();
//! assert!((transmittance - 0.0816).abs() < 1e-4);
//! # Ok::<(), freepath_estimators::ParameterError>(())
//! ```

mod bounding;
pub mod capability;
pub mod chromatic;
pub mod claims;
mod comb;
mod control;
pub mod density;
pub mod direction;
pub mod discrete;
pub mod estimate;
mod extinction;
pub mod free_path;
pub mod integral;
pub mod list;
mod majorant_choice;
mod majorants;
pub mod medium;
pub mod parameter;
mod path;
pub mod table_2d;
pub mod transmittance;
pub mod walk;
pub mod woodcock;

pub use bounding::Shortfall;
pub use capability::Capability;
pub use chromatic::ChromaticSampler;
pub use comb::Steps;
pub use density::DensitySampler;
pub use direction::DirectionSampler;
pub use discrete::DiscreteSampler;
pub use estimate::Estimator;
pub use extinction::{Cells, Extinction, Medium, Under};
pub use free_path::FreePathSampler;
pub use freepath_draws::{Draws, Key, Streams};
pub use integral::Integrator;
pub use list::List;
pub use majorant_choice::MajorantChoice;
pub use majorants::Majorants;
pub use parameter::ParameterError;
pub use path::{AuxiliaryPath, FreePath};
pub use table_2d::Table2dSampler;
pub use transmittance::TransmittanceEstimator;
pub use walk::WalkEstimator;

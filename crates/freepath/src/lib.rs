//! Samplers and estimators of one's own, of free paths, transmittances, laws, directions or anything with a known mean, judged in one line of a `cargo test`.
//!
//! A closure is a sampler; it returns the distance, or infinity for an escape:
//!
//! ```
//! use freepath::medium::Constant;
//! use freepath::{Extinction, assert_free_path};
//! use rand::{Rng, RngExt};
//!
//! let inversion = |medium: &dyn Extinction, rng: &mut dyn Rng| {
//!     let t = -(1.0 - rng.random::<f64>()).ln() / medium.mu(0.0);
//!     if t < medium.length() { t } else { f64::INFINITY }
//! };
//! assert_free_path(&inversion, &Constant::new(1.5, 2.0)?);
//! # Ok::<(), freepath::ParameterError>(())
//! ```
//!
//! | to judge | bring | with |
//! |---|---|---|
//! | free paths | a [`FreePathSampler`] and a [`Medium`] | [`assert_free_path`] |
//! | a transmittance | a [`TransmittanceEstimator`] and a [`Medium`] | [`assert_transmittance`] |
//! | weights of channels | a [`ChromaticSampler`] and a [`medium::Chromatic`] | [`assert_chromatic`] |
//! | a mean that is known | an [`Estimator`] and a [`scene::Number`] | [`assert_estimate`] |
//! | a law on a line | a [`DensitySampler`] and a [`density::Target`] | [`assert_density`] |
//! | an integral | an [`Integrator`] and an [`integral::Integrand`] | [`assert_integral`] |
//! | categories | a [`DiscreteSampler`] and [`discrete::Categories`] | [`assert_discrete`] |
//! | directions | a [`DirectionSampler`] and [`direction::Directions`] | [`assert_direction`] |
//! | a linear system or a chain by random walks | a [`WalkEstimator`] and a [`walk::System`] | [`assert_walk`] |
//! | places of a table | a [`Table2dSampler`] and a [`table_2d::Grid`] | [`assert_table_2d`] |
//! | a case file | JSON | [`check`] |
//!
//! An estimator sees an [`Extinction`] and its random numbers, never the optical depth, which is the [`Medium`]'s. Media are in
//! [`medium`], the samplers that the harness ships in [`free_path`], [`transmittance`] and [`chromatic`]; [`list!`] gives names in
//! case files to samplers of one's own, which the crate `freepath-cli` makes a command of.
//!
//! Everything is off by default: the feature `report` writes the page of a case's results (`report::write`), `vdb` reads
//! OpenVDB volumes.

#![forbid(unsafe_code)]

mod assert;
mod check;

pub use assert::{
    Effort, assert_chromatic, assert_density, assert_direction, assert_discrete, assert_estimate,
    assert_free_path, assert_integral, assert_table_2d, assert_transmittance, assert_walk, verify,
};
pub use check::check;
pub use freepath_estimators::{
    Capability, Cells, ChromaticSampler, DensitySampler, DirectionSampler, DiscreteSampler, Draws, Estimator,
    Extinction, FreePath, FreePathSampler, Integrator, Key, List, MajorantChoice, Majorants, Medium,
    ParameterError, Streams, Table2dSampler, TransmittanceEstimator, Under, WalkEstimator,
};
pub use freepath_estimators::{
    capability, chromatic, claims, density, direction, discrete, estimate, free_path, integral, list, medium,
    parameter, table_2d, transmittance, walk,
};
pub use freepath_harness::scene;
#[cfg(feature = "report")]
pub use freepath_report as report;
pub use freepath_results::{Results, Verdict};

//! Draws in, verdicts out: case files, tallies, evidence, decisions and results.
//!
//! ```text
//! Subject -> Draws -> Tally -> Evidence -> Verdict -> Report
//! ```
//!
//! Each arrow is a pure function, and only a subject is random. What is verified is data (a case); evidence comes first
//! and the decision later, over the whole run at one family-wise error.
//!
//! In a test of one's own, one line does it all. A closure is a sampler; it returns the distance, or infinity for an
//! escape:
//!
//! ```
//! use freepath_estimators::Extinction;
//! use freepath_estimators::medium::Constant;
//! use freepath_harness::assert_free_path;
//! use rand::{Rng, RngExt};
//!
//! let inversion = |medium: &dyn Extinction, rng: &mut dyn Rng| {
//!     let t = -(1.0 - rng.random::<f64>()).ln() / medium.mu(0.0);
//!     if t < medium.length() { t } else { f64::INFINITY }
//! };
//! assert_free_path(&inversion, &Constant::new(1.5, 2.0)?);
//! # Ok::<(), freepath_estimators::ParameterError>(())
//! ```
//!
//! Cases are read by [`case::CaseFile`] and run by [`run::run`]; [`power::power`] finds how many draws a fault needs to be seen.

pub mod agree;
pub mod assert;
pub mod audit;
mod blocks;
pub mod case;
pub mod collect;
pub mod describe;
pub mod diagnose;
pub mod experiment;
pub mod fault;
mod hash;
pub mod identities;
pub mod kind;
pub mod microscope;
pub mod noiseless;
pub mod power;
pub mod program;
pub mod ranking;
pub mod run;
pub mod sample;
pub mod samples;
pub mod scene;
pub mod scripted;
pub mod soak;
pub mod source;
pub mod subject;

pub use assert::{assert_chromatic, assert_free_path, assert_transmittance};
